// SPDX-License-Identifier: BSL-1.0
// A problem in TOML:
//   title = "A pendulum with friction"
//   lagrangian = "m*l^2*v^2/2 - m*g*l*(1 - cos(q))"
//   force = "-0.1*v"                                 one, or a list with one for each coordinate
//   parameters = { m = 1, g = 9.81, l = "1/3" }      numbers, lists of numbers, digits
//   coordinates = "q[2]"                             names with lengths; so are velocities; q and v where nothing is said
//   interval = [0, 100]
//   steps = 1000
//   initial = { q = 1, v = 0 }                       numbers or lists under the names of the coordinates, 0 for all that
//                                                    stands under one, or formulas of the parameters and of i, which component it is
//   embedding = "mid-point"                          or "theta:0.3", or operators: "integral(L((q + sigma[q])/2, Delta_plus[q]))"
//   damping = [ { rho = 0.2, alpha = 0.5 } ]         and history = "exponentials"
// What is looked at, and measured with, is in observed_in_file.cpp.
#include "from_file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "engine/methods/own.hpp"
#include "hilger/multiprecision.hpp"
#include "observed_in_file.hpp"

namespace program {

namespace {

namespace text = hilger::text;

class problem_reader {
public:
    problem_reader(std::string_view content, std::string path) : file_(content, std::move(path)) {}

    scene read() {
        file_.require_known(file_.all(), keys);
        names_ = coordinates("coordinates", "q");
        velocities_ = coordinates("velocities", "v");
        auto const words = vocabulary();
        stated_problem what{{text::stated_lagrangian(file_.formula(file_.required("lagrangian"), words, "lagrangian")), {}, {}, ""},
                            {},
                            {},
                            {},
                            {},
                            {},
                            {}};
        if (auto const* f = file_.get("force")) what.of.force = force(*f, words);
        if (auto const* d = file_.get("damping")) what.of.damping = damping(*d);
        auto const ends = file_.digits_of_list(file_.required("interval"), "two numbers, as interval = [0, 100]");
        if (ends.size() != 2 or not(file_.number(ends[0]) < file_.number(ends[1])))
            file_.refuse(&file_.required("interval"), "an interval is two numbers, the smaller one first");
        what.start = ends[0];
        what.end = ends[1];
        initial(what, words);

        scene s;
        s.name = std::filesystem::path(file_.path()).stem().string();
        for (char& c : s.name) // it names files, in the commands of gnuplot too
            if (not(std::isalnum(static_cast<unsigned char>(c)) or static_cast<signed char>(c) < 0 or c == '-' or c == '.')) c = '_';
        s.title = file_.get("title") != nullptr ? file_.text_of(*file_.get("title"), "title") : "a problem of " + file_.path();
        s.dimension = words->dimension();
        s.t0 = file_.number(what.start);
        s.t1 = file_.number(what.end);
        s.embeddings = embeddings_of(what);
        s.scalars = scalars_of(what);
        s.usual = {s.embeddings.size() == 1 ? s.embeddings[0] : "mid-point", "double", "",
                   file_.count_of(file_.required("steps"), "steps")};
        if (auto const* e = file_.get("embedding")) {
            std::string const method = file_.text_of(*e, "embedding");
            if (engine::is_embedding_in_text(method)) (void)text::embedding_in(method, words, file_.path(), file_.begin_of_text(*e));
            if (file_.saying_where(e, [&] { return has_embedding(what, method); })) s.embeddings.push_back(method);
            s.usual.embedding = file_.chosen(*e, "embedding", s.embeddings);
        }
        if (not what.of.damping.empty()) {
            s.histories = {"exponentials", "exponentials:1e-8", "blocks", "direct"};
            s.usual.history = "exponentials";
        }
        if (auto const* h = file_.get("history")) {
            if (what.of.damping.empty()) file_.refuse(h, "a history is for fractional damping, and there is none");
            s.usual.history = file_.chosen(*h, "history", s.histories);
        }
        s.columns = {"t"};
        for (char const* momentum : {"", "p_"})
            for (auto const& [name, size] : names_)
                for (int k = 0; k < std::max(size, 1); ++k)
                    s.columns.push_back(momentum + name + (size > 0 ? "_" + std::to_string(k) : ""));
        observe(file_, words, what, s);
        s.stated = std::make_shared<stated_problem const>(what);
        s.begin = [stated = s.stated, name = s.name](configuration const& c) {
            auto begun = begin_stated(*stated, c);
            if (not begun)
                hilger::error::raise<hilger::error::invalid_parameter>("the scene ", name, " has no ", c.embedding, " in ", c.scalar);
            return begun;
        };
        return s;
    }

private:
    static constexpr std::array<std::string_view, 18> keys{"title",    "lagrangian", "force",    "parameters", "coordinates", "velocities",
                                                           "interval", "steps",      "initial",  "embedding",  "damping",     "history",
                                                           "units",    "conserved",  "observed", "pictures",   "reference",   "exact"};

    std::shared_ptr<text::vocabulary const> vocabulary() const {
        if (names_.size() != velocities_.size()) file_.refuse(file_.get("velocities"), "there is one velocity for each coordinate");
        std::vector<text::coordinate> all;
        for (std::size_t k = 0; k < names_.size(); ++k) {
            if (names_[k].second != velocities_[k].second)
                file_.refuse(file_.get("velocities"), "a velocity has the length of its coordinate");
            all.push_back({names_[k].first, velocities_[k].first, names_[k].second});
        }
        return file_.saying_where(file_.get("coordinates"), [&] {
            auto words = std::make_shared<text::vocabulary>(all);
            if (auto const* given = file_.get("parameters"))
                for (auto const& [key, node] : file_.table_of(*given, "parameters are a table, as { m = 1, g = 9.81 }"))
                    file_.saying_where(&node, [&, &k = key, &n = node] {
                        if (n.is_array())
                            words->set(std::string(k.str()), file_.digits_of_list(n, "numbers"));
                        else
                            words->set(std::string(k.str()), file_.digits_of(n));
                        return 0;
                    });
            return std::shared_ptr<text::vocabulary const>(words);
        });
    }
    using named = std::vector<std::pair<std::string, int>>;
    /// "q[3]", or a list of such.
    [[nodiscard]] named coordinates(char const* key, char const* otherwise) const {
        named all;
        auto const add = [&](toml::node const& n, std::string const& word) {
            auto const bracket = word.find('[');
            int size = 0;
            if (bracket != std::string::npos) {
                auto const [end, wrong] = std::from_chars(word.data() + bracket + 1, word.data() + word.size(), size);
                if (wrong != std::errc() or size < 1 or size > 1'000'000 or std::string_view(end) != "]")
                    file_.refuse(&n, "a coordinate is written as \"q\" or \"q[3]\", and here is \"" + word + "\"");
            }
            all.emplace_back(word.substr(0, bracket), size);
        };
        auto const* given = file_.get(key);
        if (given == nullptr) return {{otherwise, 0}};
        if (auto const* list = given->as_array())
            for (auto const& n : *list) add(n, file_.text_of(n, key));
        else
            add(*given, file_.text_of(*given, key));
        return all;
    }
    [[nodiscard]] text::stated_force force(toml::node const& n, std::shared_ptr<text::vocabulary const> const& words) const {
        std::vector<text::stated> all;
        if (auto const* list = n.as_array())
            for (auto const& f : *list) all.push_back(file_.formula(f, words, "force"));
        else
            all.push_back(file_.formula(n, words, "force"));
        return file_.saying_where(&n, [&] { return text::stated_force(all); });
    }
    [[nodiscard]] std::vector<engine::problem::damping_term> damping(toml::node const& n) const {
        auto const* list = n.as_array();
        if (list == nullptr or list->empty()) file_.refuse(&n, "damping is a list, as [ { rho = 0.2, alpha = 0.5 } ]");
        std::vector<engine::problem::damping_term> terms;
        for (auto const& term : *list) {
            auto const* t = term.as_table();
            if (t == nullptr or t->size() != 2 or not t->contains("rho") or not t->contains("alpha"))
                file_.refuse(&term, "a term of the damping is { rho = 0.2, alpha = 0.5 }");
            terms.push_back({file_.number(file_.digits_of(*t->get("rho"))), file_.number(file_.digits_of(*t->get("alpha")))});
            if (not(terms.back().alpha > 0 and terms.back().alpha < 2)) file_.refuse(t->get("alpha"), "alpha lies between 0 and 2");
        }
        return terms;
    }
    void initial(stated_problem& what, std::shared_ptr<text::vocabulary const> const& words) const {
        auto const& n = file_.required("initial");
        auto const& given = file_.table_of(n, "initial values are a table, as { q = 1, v = 0 }");
        std::size_t used = 0;
        auto const take = [&](named const& names, std::vector<std::string>& to) {
            for (auto const& [name, size] : names) {
                auto const* values = given.get(name);
                if (values == nullptr) file_.refuse(&n, "the initial values have no '" + name + "'");
                auto const count = static_cast<std::size_t>(std::max(size, 1));
                auto const* list = values->as_array();
                bool const for_all = is_formula(*values) or values->value<double>() == 0.0;
                std::size_t const here = list != nullptr ? list->size() : for_all ? count : 1;
                if (here != count)
                    file_.refuse(values,
                                 "'" + name + "' has " + std::to_string(count) + " initial values, and here are " + std::to_string(here));
                for (std::size_t k = 0; k < count; ++k) to.push_back(initial_value(list != nullptr ? *list->get(k) : *values, k, words));
                ++used;
            }
        };
        take(names_, what.q);
        take(velocities_, what.v);
        if (used != given.size()) file_.refuse(&n, "there are initial values of what is no coordinate and no velocity");
    }
    [[nodiscard]] static bool is_formula(toml::node const& n) {
        auto const s = n.value_exact<std::string>();
        return s and not text::number_in<double>(*s);
    }
    /// A number, or what a formula of the parameters and of i is in a hundred digits.
    [[nodiscard]] std::string initial_value(toml::node const& n, std::size_t i,
                                            std::shared_ptr<text::vocabulary const> const& words) const {
        using R = hilger::float100;
        if (not is_formula(n)) return file_.digits_of(n);
        auto known = std::make_shared<text::vocabulary>(*words);
        if (known->find("i") == nullptr) known->set("i", std::to_string(i));
        text::stated const f = file_.formula(n, known, "an initial value");
        if (f.reads_state())
            file_.refuse(&n, "an initial value is a number, or a formula of the parameters and of i, which component it is");
        R const value = f.number<R>();
        if (not(abs(value) <= R(std::numeric_limits<double>::max()))) file_.refuse(&n, "this initial value is not a finite number");
        return value.str(std::numeric_limits<R>::max_digits10, std::ios::scientific);
    }

    toml_file file_;
    named names_, velocities_;
};

} // namespace

scene scene_from_text(std::string_view content, std::string const& path) { return problem_reader(content, path).read(); }

scene scene_from_file(std::string const& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream content;
    if (not in or not(content << in.rdbuf())) hilger::error::raise<hilger::error::unreadable>("cannot read a problem from '", path, "'");
    return scene_from_text(content.str(), path);
}

} // namespace program
