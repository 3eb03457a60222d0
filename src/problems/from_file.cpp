// SPDX-License-Identifier: BSL-1.0
// A problem in TOML:
//   title = "A pendulum with friction"
//   lagrangian = "m*l^2*v^2/2 - m*g*l*(1 - cos(q))"
//   force = "-0.1*v"                                 one, or a list with one for each coordinate
//   parameters = { m = 1, g = 9.81, l = "1/3" }      numbers, lists of numbers, digits
//   coordinates = "q[2]"                             names with lengths; so are velocities; q and v where nothing is said
//   interval = [0, 100]                              or "2*pi"
//   steps = 1000
//   initial = { q = 1, v = 0 }                       numbers or lists under the names of the coordinates, 0 for all that
//                                                    stands under one, or formulas of the parameters and of i, which component it is
//   embedding = "mid-point"                          or "theta:0.3", or operators: "integral(L((q + sigma[q])/2, Delta_plus[q]))"
//   damping = [ { rho = 0.2, alpha = 0.5 } ]         and history = "exponentials"
//   material = { relaxed_modulus = 1e6, unrelaxed_modulus = 5e7, relaxation_time = 1e-3, alpha = 0.5 }     instead, of a linear structure
//   first = { q = 0 }                                and last = { q = 1 } instead of initial: between two ends
// What is looked at, and measured with, is in observed_in_file.cpp.
#include "from_file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "engine/methods/lambda.hpp"
#include "hilger/multiprecision.hpp"
#include "parts_of_file.hpp"

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
        stated_problem what(text::stated_lagrangian(file_.formula(file_.required("lagrangian"), words, "lagrangian")));
        if (auto const* f = file_.get("force")) what.of.force = force(*f, words);
        if (auto const* d = file_.get("damping")) what.of.damping = damping(*d);
        if (auto const* m = file_.get("material")) what.of.material = material(*m, what.of);
        interval(what);
        if (file_.get("first") != nullptr or file_.get("last") != nullptr)
            both_ends(what, words);
        else
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
        s.scalars = scalars_of(what, s.embeddings);
        bool const has_midpoint = std::find(s.embeddings.begin(), s.embeddings.end(), "mid-point") != s.embeddings.end();
        s.usual = {has_midpoint ? "mid-point" : s.embeddings[0], "double", "", file_.count_of(file_.required("steps"), "steps")};
        if (auto const* e = file_.get("embedding")) {
            std::string const method = file_.text_of(*e, "embedding");
            if (engine::is_embedding_in_text(method)) (void)text::embedding_in(method, words, file_.path(), file_.begin_of_text(*e));
            if (std::find(s.embeddings.begin(), s.embeddings.end(), method) == s.embeddings.end() and
                file_.saying_where(e, [&] { return has_embedding(what, method); }))
                s.embeddings.push_back(method);
            s.usual.embedding = file_.chosen(*e, "embedding", s.embeddings);
            if (method.starts_with("two-sided:")) s.embeddings = {method}; // another equation than all others
        }
        if (what.of.has_memory()) {
            s.histories = {"exponentials", "exponentials:1e-8", "blocks", "direct"};
            if (s.embeddings.size() > 1) s.histories.emplace_back("window:1000"); // of Newmark's schemes
            s.usual.history = "exponentials";
        }
        if (auto const* h = file_.get("history")) {
            if (not what.of.has_memory()) file_.refuse(h, "a history is for fractional damping, and there is none");
            s.usual.history = file_.chosen(*h, "history", s.histories, true);
        }
        s.columns = {"t"};
        for (char const* momentum : {"", "p_"})
            if (what.last.empty() or *momentum == '\0')
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
    static constexpr std::array<std::string_view, 21> keys{"title",    "lagrangian", "force",   "parameters", "coordinates", "velocities",
                                                           "interval", "steps",      "initial", "first",      "last",        "embedding",
                                                           "damping",  "material",   "history", "units",      "conserved",   "observed",
                                                           "pictures", "reference",  "exact"};

    std::shared_ptr<text::vocabulary const> vocabulary() const {
        if (names_.size() != velocities_.size()) file_.refuse(file_.get("velocities"), "there is one velocity for each coordinate");
        std::vector<text::coordinate> all;
        for (std::size_t k = 0; k < names_.size(); ++k) {
            if (names_[k].second != velocities_[k].second)
                file_.refuse(file_.get("velocities"), "a velocity has the length of its coordinate, and '" + velocities_[k].first +
                                                          "' has not that of '" + names_[k].first + "': velocities = \"v[3]\" says it");
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
    /// "q[3]", or a list of such.
    [[nodiscard]] named_coordinates coordinates(char const* key, char const* otherwise) const {
        named_coordinates all;
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
            terms.push_back({exactly(*t->get("rho")), exactly(*t->get("alpha"))});
            if (not(terms.back().alpha > 0 and terms.back().alpha < 2)) file_.refuse(t->get("alpha"), "alpha lies between 0 and 2");
        }
        return terms;
    }
    [[nodiscard]] engine::problem::zener_material material(toml::node const& n, engine::problem const& of) const {
        auto const& t =
            file_.table_of(n, "a material is { relaxed_modulus = 1e6, unrelaxed_modulus = 5e7, relaxation_time = 1e-3, alpha = 0.5 }");
        constexpr std::array<std::string_view, 4> known{"relaxed_modulus", "unrelaxed_modulus", "relaxation_time", "alpha"};
        file_.require_known(t, known);
        for (auto const& key : known)
            if (not t.contains(key)) file_.refuse(&n, "a material has " + std::string(key) + ", and this one has not");
        if (not of.damping.empty()) file_.refuse(&n, "there is a material or damping, and here are both");
        engine::problem one = of;
        one.material = {exactly(*t.get("relaxed_modulus")), exactly(*t.get("unrelaxed_modulus")), exactly(*t.get("relaxation_time")),
                        exactly(*t.get("alpha"))};
        file_.saying_where(&n, [&] {
            require_structure(one);
            return 0;
        });
        return *one.material;
    }
    void interval(stated_problem& what) const {
        auto const& n = file_.required("interval");
        auto const* list = n.as_array();
        if (list == nullptr) file_.refuse(&n, "a list was expected, of two numbers, as interval = [0, 100]");
        values_in_file const values(file_, text::no_words());
        std::vector<std::string> ends;
        for (auto const& end : *list) ends.push_back(values.end_of_interval(end));
        if (ends.size() != 2 or not(file_.number(ends[0]) < file_.number(ends[1])))
            file_.refuse(&n, "an interval is two numbers, the smaller one first");
        what.start = ends[0];
        what.end = ends[1];
    }
    /// What digits in a file spell.
    [[nodiscard]] hilger::float100 exactly(toml::node const& n) const { return *text::number_in<hilger::float100>(file_.digits_of(n)); }
    void initial(stated_problem& what, std::shared_ptr<text::vocabulary const> const& words) const {
        values_in_file(file_, words)
            .read("initial", "initial values are a table, as { q = 1, v = 0 }",
                  {{names_, what.q, what.q_formulas}, {velocities_, what.v, what.v_formulas}});
    }
    void both_ends(stated_problem& what, std::shared_ptr<text::vocabulary const> const& words) const {
        if (auto const* n = file_.get("initial")) file_.refuse(n, "there are initial values, or first and last ones, and here are both");
        if (what.of.has_memory()) file_.refuse(file_.get("last"), "fractional damping has initial values, and not a last one");
        values_in_file const values(file_, words);
        std::vector<initial_formula> not_asked_for;
        values.read("first", "first values are a table, as { q = 0 }", {{names_, what.q, not_asked_for}});
        values.read("last", "last values are a table, as { q = 1 }", {{names_, what.last, not_asked_for}});
    }
    toml_file file_;
    named_coordinates names_, velocities_;
};

} // namespace

scene scene_from_text(std::string_view content, std::string const& path) {
    scene s = problem_reader(content, path).read();
    std::uint64_t hash = 0xcbf29ce484222325U; // FNV-1a
    for (char const c : content) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
    s.fingerprint = std::to_string(hash);
    return s;
}

scene scene_from_file(std::string const& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream content;
    if (not in or std::filesystem::is_directory(path))
        hilger::error::raise<hilger::error::unreadable>("cannot read a problem from '", path, "'");
    content << in.rdbuf(); // nothing, where the file is empty
    return scene_from_text(content.str(), path);
}

} // namespace program
