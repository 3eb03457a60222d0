// SPDX-License-Identifier: BSL-1.0
// A problem in TOML:
//   title = "A pendulum with friction"
//   lagrangian = "m*l^2*v^2/2 - m*g*l*(1 - cos(q))"
//                                                    or a list of summands, with one embedding or a list of one for each
//   force = "-0.1*v"                                 one, or a list with one for each coordinate
//   parameters = { m = 1, g = 9.81, l = "1/3" }      numbers, lists of numbers, digits
//   coordinates = "q[2]"                             names with lengths; velocities likewise; by default q and v
//   interval = [0, 100]                              or "2*pi"
//   steps = 1000
//   initial = { q = 1, v = 0 }                       numbers, lists, or formulas of the parameters and of the index i; 0
//                                                    or one formula also stands for all components of a name
//   embedding = "mid-point"                          or "theta:0.3", or operators: "integral(L((q + sigma[q])/2, Delta_plus[q]))"
//   damping = [ { rho = 0.2, alpha = 0.5 } ]         and history = "exponentials"
//   time_transformation = "sundman(1.5)"             or "inverse_potential", or a formula of the positions: the g of dt = g(q) dtau, with
//                                                    interval and steps in tau (hilger/text/time_transformation.hpp)
//   material = { relaxed_modulus = 1e6, unrelaxed_modulus = 5e7, relaxation_time = 1e-3, alpha = 0.5 }     instead, of a linear structure
//   first = { q = 0 }                                and last = { q = 1 } instead of initial: between two ends
// Observed quantities and the reference are in observed_in_file.cpp.
#include "from_file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "engine/methods/histories.hpp"
#include "engine/methods/lambda.hpp"
#include "hilger/multiprecision.hpp"
#include "mechanics_in_file.hpp"
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
        mechanics_in_file const mechanics(file_, words);
        stated_problem what = mechanics.read();
        mechanics.transform_time(what, all_coordinates());
        interval(what);
        if (file_.get("first") != nullptr or file_.get("last") != nullptr)
            both_ends(what, words);
        else
            initial(what, words);

        scene s;
        s.name = std::filesystem::path(file_.path()).stem().string();
        for (char& c : s.name) // it becomes file names, in the commands of gnuplot too
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
            if (auto const* list = e->as_array(); list != nullptr and list->size() == 1) e = list->get(0);
            std::string const method = mechanics.embedding(*e, what);
            if (what.parts.empty() and engine::is_embedding_in_text(method))
                (void)text::embedding_in(file_.text_of(*e, "embedding"), words, file_.path(), file_.begin_of_text(*e));
            if (std::find(s.embeddings.begin(), s.embeddings.end(), method) == s.embeddings.end()) {
                if (not file_.saying_where(e, [&] { return has_embedding(what, method); }))
                    (void)file_.chosen(*e, "embedding", s.embeddings); // its error lists them
                s.embeddings.push_back(method);
            }
            s.usual.embedding = method;
            if (method.starts_with("two-sided:")) s.embeddings = {method}; // its equation differs from all others
        }
        if (what.of.has_memory()) {
            s.histories = {"exponentials", "exponentials:1e-8", "blocks", "direct"};
            s.usual.history = "exponentials";
        }
        if (auto const* h = file_.get("history")) {
            if (not what.of.has_memory()) file_.refuse(h, "a history is for fractional damping, and there is none");
            s.usual.history = file_.chosen(*h, "history", s.histories, true);
            file_.saying_where(h, [&] { engine::require_history(s.usual.history); });
        }
        s.columns = {"t"};
        for (char const* momentum : {"", "p_"})
            if (what.last.empty() or *momentum == '\0')
                for (auto const& [name, size] : names_)
                    for (int k = 0; k < std::max(size, 1); ++k)
                        s.columns.push_back(momentum + name + (size > 0 ? "_" + std::to_string(k) : ""));
        for (auto column = s.columns.begin(); column != s.columns.end(); ++column)
            if (std::find(s.columns.begin(), column, *column) != column)
                file_.refuse(file_.get("coordinates"), "two columns of the rows would be called '" + *column + "'");
        observe(file_, words, what, s);
        s.stated = std::make_shared<stated_problem const>(what);
        s.begin = [stated = s.stated, name = s.name, embeddings = s.embeddings](configuration const& c) {
            if (not has_method(*stated, c))
                hilger::error::raise<hilger::error::invalid_parameter>("the scene ", name, " has no ", c.embedding, " in ", c.scalar,
                                                                       ", and has ", listed_in(*stated, c, embeddings));
            return begin_stated(*stated, c);
        };
        return s;
    }

private:
    /// The embeddings available in the scalar of c.
    static std::string listed_in(stated_problem const& what, configuration c, std::vector<std::string> const& embeddings) {
        std::string text;
        for (auto const& e : embeddings) {
            c.embedding = e;
            if (has_method(what, c)) text += (text.empty() ? "" : ", ") + e;
        }
        return text;
    }
    static constexpr std::array<std::string_view, 22> keys{
        "title",    "lagrangian", "force",     "parameters", "coordinates",         "velocities", "interval", "steps", "initial",
        "first",    "last",       "embedding", "damping",    "time_transformation", "material",   "history",  "units", "conserved",
        "observed", "pictures",   "reference", "exact"};

    std::vector<text::coordinate> all_coordinates() const {
        if (names_.size() != velocities_.size()) file_.refuse(file_.get("velocities"), "there is one velocity for each coordinate");
        std::vector<text::coordinate> all;
        for (std::size_t k = 0; k < names_.size(); ++k) {
            if (names_[k].second != velocities_[k].second)
                file_.refuse(file_.get("velocities"), "a velocity has the length of its coordinate, and '" + velocities_[k].first +
                                                          "' has not that of '" + names_[k].first + "': velocities = \"v[3]\" says it");
            all.push_back({names_[k].first, velocities_[k].first, names_[k].second});
        }
        return all;
    }
    std::shared_ptr<text::vocabulary const> vocabulary() const {
        return file_.saying_where(file_.get("coordinates"), [&, all = all_coordinates()] {
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
    void initial(stated_problem& what, std::shared_ptr<text::vocabulary const> const& words) const {
        values_in_file(file_, words)
            .read("initial", "initial values are a table, as { q = 1, v = 0 }",
                  {{names_, what.q, what.q_formulas}, {velocities_, what.v, what.v_formulas}});
    }
    void both_ends(stated_problem& what, std::shared_ptr<text::vocabulary const> const& words) const {
        if (auto const* n = file_.get("initial")) file_.refuse(n, "there are initial values, or first and last ones, and here are both");
        if (what.of.has_memory()) file_.refuse(file_.get("last"), "fractional damping has initial values, and not a last one");
        if (what.of.time_transformation)
            file_.refuse(file_.get("last"), "in a transformed time a motion has initial values, with its energy, and not a last one");
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
    content << in.rdbuf(); // empty for an empty file
    return scene_from_text(content.str(), path);
}

} // namespace program
