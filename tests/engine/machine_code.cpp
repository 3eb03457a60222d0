// SPDX-License-Identifier: BSL-1.0
// Machine code of a formula does, to the last bit, what the formula does when it is interpreted; and what is kept of it is used only where
// it is known to be the same.
#include <doctest/doctest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>

#include <dlfcn.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "engine/machine_code/machine_code.hpp"
#include "support/random_lagrangian.hpp"
#include "support/there.hpp"

namespace machine_code_tests {

using namespace hilger;
using testing::in_text;
using testing::random_potential;
using testing::typed;

namespace {

namespace files = std::filesystem;
using vector = Eigen::VectorXd;
using evaluation = detail::evaluation<double>;
using translation = detail::translation<double>;

struct folder {
    folder() : path(files::temp_directory_path() / ("hilger_machine_code_" + std::to_string(::getpid()))) {
        files::remove_all(path);
        files::create_directory(path);
    }
    ~folder() { files::remove_all(path); }
    folder(folder const&) = delete;
    folder& operator=(folder const&) = delete;
    files::path path;
};
/// Under the embedding with position (1 - lambda) q + lambda sigma[q].
template <class L>
auto walked(L const& of, index_type steps, double lambda = 0.5) {
    vector const q{{0.5, -0.75}}, p{{0.25, 1.0}};
    auto const how = make_embedding<delta_weight>((1 - lambda) * identity_T + lambda * sigma, Delta_plus, "lambda");
    return record(embed(lagrangian{of}, how).along(uniform(0.25, 0.03125, steps), q, p), keep_partial);
}
/// Of order-one, of mid-point, and any other.
double random_lambda(unsigned seed) {
    constexpr double some[] = {0.5, 0, 1};
    return seed % 5 < 3 ? some[seed % 5] : static_cast<double>(std::mt19937(seed)() % 1000) / 700 - 0.2;
}
template <class A, class B>
void check_same_bits(A const& here, B const& there) {
    REQUIRE(here.states.size() == there.states.size());
    for (std::size_t i = 0; i < here.states.size(); ++i) {
        CHECK(here.states[i].q == there.states[i].q);
        CHECK(here.states[i].p == there.states[i].p);
    }
}

/// Collects the C of all that is evaluated often; compiles it once, in one file; then translates.
class in_one_file final : public detail::translator<double> {
public:
    void translate(evaluation const& what, translation& to) override {
        std::string const text = engine::c_of(what);
        auto const at = numbers_.try_emplace(text, numbers_.size()).first->second;
        if (at < made_.size()) to.set(made_[at]);
    }
    void compile(files::path const& where) {
        std::ofstream out(where / "all.c");
        for (auto const& [text, number] : numbers_) {
            for (int k = 0; k < translation::functions; ++k) out << "#define part_" << k << " f" << number << "_part_" << k << '\n';
            out << text;
            for (int k = 0; k < translation::functions; ++k) out << "#undef part_" << k << '\n';
        }
        out.close();
        std::string const library = (where / "all.so").string();
        REQUIRE(std::system(
                    ("${CC:-cc} -O1 -shared -fPIC -ffp-contract=off -o " + library + ' ' + (where / "all.c").string() + " -lm").c_str()) ==
                0);
        void* const loaded = ::dlopen(library.c_str(), RTLD_NOW);
        REQUIRE(loaded != nullptr);
        made_.resize(numbers_.size());
        for (std::size_t n = 0; n < made_.size(); ++n)
            for (std::size_t k = 0; k < made_[n].size(); ++k) {
                auto const name = 'f' + std::to_string(n) + "_part_" + std::to_string(k);
                made_[n][k] = reinterpret_cast<translation::function>(::dlsym(loaded, name.c_str()));
                REQUIRE(bool(made_[n][k] != nullptr));
            }
    }
    [[nodiscard]] std::size_t formulas() const { return numbers_.size(); }

private:
    std::map<std::string, std::size_t> numbers_;
    std::vector<std::array<translation::function, translation::functions>> made_;
};
/// While it lives formulas are translated by `one`.
class translated_by {
public:
    explicit translated_by(detail::translator<double>* one) : before_(installed().exchange(one)) {}
    ~translated_by() { installed() = before_; }
    translated_by(translated_by const&) = delete;
    translated_by& operator=(translated_by const&) = delete;

private:
    static auto installed() -> std::atomic<detail::translator<double>*>& { return detail::translator<double>::installed(); }
    detail::translator<double>* before_;
};
/// While it lives formulas become machine code at once, kept there.
class kept_in {
public:
    explicit kept_in(files::path const& there) {
        ::setenv("XDG_CACHE_HOME", there.c_str(), 1);
        engine::set_machine_code(engine::machine_code::at_once);
    }
    ~kept_in() { engine::set_machine_code(engine::machine_code::off); }
    kept_in(kept_in const&) = delete;
    kept_in& operator=(kept_in const&) = delete;
};

} // namespace

TEST_CASE("200 random Lagrangians under random embeddings, typed, interpreted and compiled, take the same steps bit for bit") {
    constexpr index_type steps = 300; // often enough for every branch that is more than looked at
    folder const here;
    static in_one_file translator;
    int whole = 0;
    std::vector<decltype(walked(in_text(std::declval<random_potential const&>()), 1))> interpreted;
    for (unsigned seed = 0; seed < 200; ++seed) {
        random_potential const U(seed);
        double const lambda = random_lambda(seed);
        interpreted.push_back(walked(in_text(U), steps, lambda));
        check_same_bits(interpreted.back(), walked(typed{&U}, steps, lambda));
        translated_by const collecting(&translator);
        (void)walked(in_text(U), steps, lambda);
        whole += not interpreted.back().stopped;
    }
    CHECK(whole > 100);
    CHECK(translator.formulas() > 150);
    if (not testing::there_is_a_c_compiler()) return;
    translator.compile(here.path);
    for (unsigned seed = 0; seed < 200; ++seed) {
        CAPTURE(seed);
        translated_by const translating(&translator);
        check_same_bits(walked(in_text(random_potential(seed)), steps, random_lambda(seed)), interpreted[seed]);
    }
}

TEST_CASE("long formulas of neighbours, with masses that move, are loops, and the same") {
    auto const chain = [](auto const& q, auto const& v) {
        auto sum = v(0) * v(0) / 2;
        for (int k = 1; k < 60; ++k) {
            auto const r = q(k) - q(k - 1);
            sum = sum + v(k) * v(k) * (2 + cos(q(k))) / 4 - r * r / 2 - r * r * r * r / 4 + cos(q(k)) / 8 - exp(-q(k) * q(k)) / 16 -
                  log(2 + q(k) / 2) / 32 - sqrt(r * r + q(k) * q(k)) / 64 - cos(exp(-q(k) * q(k)) * exp(-q(1) * q(1))) / 128;
        }
        return sum;
    };
    vector const q = vector::LinSpaced(60, -0.5, 0.75), p = vector::Zero(60);
    auto const walk = [&] { return record(embed(lagrangian{chain}, mid_point).along(uniform(0.0, 0.0625, 400), q, p)); };
    auto const interpreted = walk();
    if (not testing::there_is_a_c_compiler()) return;
    folder const here;
    kept_in const cache(here.path);
    int const before = engine::formulas_in_machine_code();
    auto const compiled = walk();
    CHECK(engine::formulas_in_machine_code() > before); // one element of a row is no part of its loop, or this would be no C
    CHECK(compiled.states == interpreted.states);
    std::string all;
    for (auto const& file : files::directory_iterator(here.path / "hilger"))
        if (file.path().extension() == ".c") all = std::string(std::istreambuf_iterator<char>(std::ifstream(file.path()).rdbuf()), {});
    CHECK(all.find("for (int i = 0; i < 59; ++i)") != std::string::npos);
    CHECK(all.find(" sin(") != std::string::npos);
    CHECK(all.find(" < 0 ? log(") != std::string::npos);
    CHECK(all.find(" == 0 ? ") != std::string::npos);
    CHECK(std::count(all.begin(), all.end(), '\n') < 1100); // of several thousand operations
}

TEST_CASE("what is compiled is kept, and used where it is the same text in a folder of one's own") {
    if (not testing::there_is_a_c_compiler()) return;
    folder const here;
    kept_in const cache(here.path);
    files::path const kept = here.path / "hilger";
    auto const translated = [] { return engine::formulas_in_machine_code(); };
    auto const check = [&](unsigned seed, bool becomes_machine_code) {
        CAPTURE(seed);
        random_potential const U(seed);
        int const before = translated();
        auto const with = walked(in_text(U), 300);
        CHECK((translated() > before) == becomes_machine_code);
        engine::set_machine_code(engine::machine_code::off);
        check_same_bits(with, walked(in_text(U), 300));
        engine::set_machine_code(engine::machine_code::at_once);
    };
    check(1000, true);
    CHECK(not files::is_empty(kept));
    for (auto const& file : files::directory_iterator(kept)) {
        bool const is_kept = file.path().extension() == ".c" or file.path().extension() == ".so";
        CHECK_MESSAGE(is_kept, file.path());
        CHECK(file.path().stem().extension().empty()); // of the process at work nothing is left
    }
    ::setenv("CC", "/nowhere/cc", 1);
    check(1000, true);
    ::unsetenv("CC");

    SUBCASE("a folder that others may write into") {
        files::permissions(kept, files::perms::others_write, files::perm_options::add);
        check(1001, false);
        files::permissions(kept, files::perms::others_write, files::perm_options::remove);
        check(1002, true);
    }
    SUBCASE("no folder") {
        ::setenv("XDG_CACHE_HOME", "/dev/null/nowhere", 1);
        check(1003, false);
    }
    SUBCASE("another text under the same name") {
        for (auto const& file : files::directory_iterator(kept))
            if (file.path().extension() == ".c") std::ofstream(file.path(), std::ios::app) << "/* another */\n";
        engine::set_machine_code(engine::machine_code::at_once); // forgets what it has looked at
        check(1000, false);
    }
    SUBCASE("no compiler") {
        ::setenv("CC", "/nowhere/cc", 1);
        check(1005, false);
        ::setenv("CC", "cc -pipe", 1);
        check(1006, true);
        ::unsetenv("CC");
    }
}

namespace {
std::vector<files::path> files_in(files::path const& there) { return {files::directory_iterator(there), {}}; }
/// Steps of a seed, translated at once; whether they are those that are interpreted.
bool are_the_same(unsigned seed) {
    random_potential const U(seed);
    engine::set_machine_code(engine::machine_code::at_once); // forgets what it has looked at
    auto const with = walked(in_text(U), 300);
    engine::set_machine_code(engine::machine_code::off);
    auto const without = walked(in_text(U), 300);
    engine::set_machine_code(engine::machine_code::at_once);
    return std::equal(with.states.begin(), with.states.end(), without.states.begin(), without.states.end(),
                      [](auto const& a, auto const& b) { return a.q == b.q and a.p == b.p; });
}
} // namespace

TEST_CASE("512 files stay, and those that were used last") {
    if (not testing::there_is_a_c_compiler()) return;
    folder const here;
    kept_in const cache(here.path);
    files::path const kept = here.path / "hilger";
    CHECK(are_the_same(1000));
    auto const used = files_in(kept);
    CHECK(used.size() >= 2);
    auto const hours_ago = [](int hours) { return files::file_time_type::clock::now() - std::chrono::hours(hours); };
    for (auto const& file : used) files::last_write_time(file, hours_ago(2000));
    std::vector<files::path> older;
    for (int k = 0; k < 600; ++k) {
        older.push_back(kept / ("older" + std::to_string(k)));
        std::ofstream(older.back()) << k;
        files::last_write_time(older.back(), hours_ago(1000 - k));
    }
    CHECK(are_the_same(1000)); // from what is kept, which is the oldest
    CHECK(files_in(kept).size() == used.size() + older.size());
    CHECK(are_the_same(1001));
    CHECK(files_in(kept).size() == 512);
    for (auto const& file : used) CHECK(files::exists(file));
    CHECK(not files::exists(older.front()));
    CHECK(files::exists(older.back()));
}

TEST_CASE("processes that compile the same, while what is kept goes, all take the same steps") {
    if (not testing::there_is_a_c_compiler()) return;
    folder const here;
    kept_in const cache(here.path);
    files::path const kept = here.path / "hilger";
    int const before = engine::formulas_in_machine_code();
    CHECK(are_the_same(1000));
    CHECK(engine::formulas_in_machine_code() > before);
    std::vector<::pid_t> others;
    for (int k = 0; k < 4; ++k) {
        others.push_back(::fork());
        if (others.back() != 0) continue;
        bool all = true;
        for (unsigned seed = 1000; seed < 1012; ++seed) all = are_the_same(seed % 4 + 1000) and all;
        ::_exit(all ? 0 : 1);
    }
    for (std::size_t running = others.size(); running > 0;) {
        std::error_code never_mind;
        for (auto const& file : files_in(kept))
            if (file.stem().extension().empty()) files::remove(file, never_mind); // none that is being compiled
        int code = 0;
        if (::waitpid(-1, &code, WNOHANG) <= 0) continue;
        CHECK(code == 0);
        --running;
    }
}

} // namespace machine_code_tests
