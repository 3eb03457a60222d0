// SPDX-License-Identifier: BSL-1.0
// A problem in TOML:
//   title = "A pendulum with friction"
//   lagrangian = "m*l^2*v^2/2 - m*g*l*(1 - cos(q))"
//   force = "-0.1*v"                                 one, or a list with one for each coordinate
//   parameters = { m = 1, g = 9.81, l = "1/3" }      numbers, lists of numbers, digits
//   coordinates = "q[2]"                             names with lengths; so are velocities; q and v where nothing is said
//   interval = [0, 100]
//   steps = 1000
//   initial = { q = 1, v = 0 }                       numbers or lists under the names of the coordinates
//   embedding = "mid-point"
//   damping = [ { rho = 0.2, alpha = 0.5 } ]         and history = "exponentials"
#include "from_file.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>

// Version 3.3 asserts what a file decides, as that a header begins with a letter: such a file is refused, and does not end the program.
#define TOML_ASSERT(condition) ((condition) ? void() : throw std::domain_error(#condition))
#define TOML_EXCEPTIONS 1
#include <stdexcept>
#if defined(__GNUC__) and not defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wterminate" // where nothing may be thrown the program ends, as with assert
#endif
#include <toml++/toml.h>
#if defined(__GNUC__) and not defined(__clang__)
#pragma GCC diagnostic pop
#endif

#include "hilger/error.hpp"
#include "hilger/formula/print.hpp"
#include "histories.hpp"

namespace program {

namespace {

namespace text = hilger::text;

class file_reader {
public:
    file_reader(std::string_view content, std::string path) : path_(std::move(path)) {
        try {
            file_ = toml::parse(content);
        } catch (toml::parse_error const& e) {
            refuse(e.source().begin, std::string(e.description()));
        } catch (std::domain_error const&) {
            hilger::error::raise<hilger::error::unreadable>(path_, ": this is no TOML");
        }
    }

    scene read() {
        for (auto const& [key, node] : file_)
            if (std::find(keys.begin(), keys.end(), key.str()) == keys.end()) {
                std::string known;
                for (auto const& k : keys) known += (known.empty() ? "" : ", ") + std::string(k);
                refuse(key.source().begin, "there is no key '" + std::string(key.str()) + "': there are " + known);
            }
        auto const words = vocabulary();
        stated_problem what{{lagrangian(words), {}, {}, ""}, {}, {}, {}, {}};
        if (auto const* f = file_.get("force")) what.of.force = force(*f, words);
        if (auto const* d = file_.get("damping")) what.of.damping = damping(*d);
        auto const ends = digits_of_list(required("interval"), "two numbers, as interval = [0, 100]");
        if (ends.size() != 2 or not(number(ends[0]) < number(ends[1])))
            refuse(required("interval").source().begin, "an interval is two numbers, the smaller one first");
        what.start = ends[0];
        what.end = ends[1];
        initial(what);

        scene s;
        s.name = std::filesystem::path(path_).stem().string();
        s.title = file_.contains("title") ? text_of(*file_.get("title"), "title").first : "a problem of " + path_;
        s.dimension = words->dimension();
        s.t0 = number(what.start);
        s.t1 = number(what.end);
        s.embeddings = embeddings_of(what);
        s.scalars = {"double"};
        s.usual = {s.embeddings.size() == 1 ? s.embeddings[0] : "mid-point", "double", "", steps()};
        if (auto const* e = file_.get("embedding")) s.usual.embedding = chosen(*e, "embedding", s.embeddings);
        if (not what.of.damping.empty()) {
            s.histories = {"exponentials", "exponentials:1e-8", "blocks", "direct"};
            s.usual.history = "exponentials";
        }
        if (auto const* h = file_.get("history")) {
            if (what.of.damping.empty()) refuse(h->source().begin, "a history is for fractional damping, and there is none");
            s.usual.history = chosen(*h, "history", s.histories);
        }
        describe(s, what);
        s.stated = std::make_shared<stated_problem const>(what);
        s.begin = [stated = s.stated](configuration const& c) { return begin_stated(*stated, c); };
        s.reference = s.usual;
        s.reference.embedding = s.embeddings.back();
        return s;
    }

private:
    static constexpr std::array<std::string_view, 12> keys{"title",    "lagrangian", "force",   "parameters", "coordinates", "velocities",
                                                           "interval", "steps",      "initial", "embedding",  "damping",     "history"};

    std::shared_ptr<text::vocabulary const> vocabulary() {
        names_ = coordinates("coordinates", "q");
        auto const velocities = coordinates("velocities", "v");
        if (names_.size() != velocities.size()) refuse(file_.get("velocities"), "there is one velocity for each coordinate");
        std::vector<text::coordinate> all;
        for (std::size_t k = 0; k < names_.size(); ++k) {
            if (names_[k].second != velocities[k].second) refuse(file_.get("velocities"), "a velocity has the length of its coordinate");
            all.push_back({names_[k].first, velocities[k].first, names_[k].second});
        }
        velocities_ = velocities;
        return saying_where(file_.get("coordinates"), [&] {
            auto words = std::make_shared<text::vocabulary>(all);
            if (auto const* given = file_.get("parameters")) {
                if (not given->is_table()) refuse(given, "parameters are a table, as { m = 1, g = 9.81 }");
                for (auto const& [key, node] : *given->as_table())
                    saying_where(&node, [&, &k = key, &n = node] {
                        if (n.is_array())
                            words->set(std::string(k.str()), digits_of_list(n, "numbers"));
                        else
                            words->set(std::string(k.str()), digits_of(n));
                        return 0;
                    });
            }
            return std::shared_ptr<text::vocabulary const>(words);
        });
    }
    using named = std::vector<std::pair<std::string, int>>;
    /// "q[3]", or a list of such.
    named coordinates(char const* key, char const* otherwise) {
        named all;
        auto const add = [&](toml::node const& n, std::string const& word) {
            auto const bracket = word.find('[');
            int size = 0;
            if (bracket != std::string::npos) {
                auto const [end, wrong] = std::from_chars(word.data() + bracket + 1, word.data() + word.size(), size);
                if (wrong != std::errc() or size < 1 or size > 1'000'000 or std::string_view(end) != "]")
                    refuse(n.source().begin, "a coordinate is written as \"q\" or \"q[3]\", and here is \"" + word + "\"");
            }
            all.emplace_back(word.substr(0, bracket), size);
        };
        auto const* given = file_.get(key);
        if (given == nullptr) return {{otherwise, 0}};
        if (auto const* list = given->as_array())
            for (auto const& n : *list) add(n, text_of(n, key).first);
        else
            add(*given, text_of(*given, key).first);
        return all;
    }
    text::stated_lagrangian lagrangian(std::shared_ptr<text::vocabulary const> const& words) {
        return text::stated_lagrangian(formula(required("lagrangian"), words, "lagrangian"));
    }
    text::stated formula(toml::node const& n, std::shared_ptr<text::vocabulary const> const& words, char const* key) {
        auto const [content, at] = text_of(n, key);
        return {text::read(content, path_, {static_cast<int>(at.line), static_cast<int>(at.column) + 1}), words, path_};
    }
    text::stated_force force(toml::node const& n, std::shared_ptr<text::vocabulary const> const& words) {
        std::vector<text::stated> all;
        if (auto const* list = n.as_array())
            for (auto const& f : *list) all.push_back(formula(f, words, "force"));
        else
            all.push_back(formula(n, words, "force"));
        return saying_where(&n, [&] { return text::stated_force(all); });
    }
    std::vector<engine::problem::damping_term> damping(toml::node const& n) {
        auto const* list = n.as_array();
        if (list == nullptr or list->empty()) refuse(&n, "damping is a list, as [ { rho = 0.2, alpha = 0.5 } ]");
        std::vector<engine::problem::damping_term> terms;
        for (auto const& term : *list) {
            auto const* t = term.as_table();
            if (t == nullptr or t->size() != 2 or not t->contains("rho") or not t->contains("alpha"))
                refuse(&term, "a term of the damping is { rho = 0.2, alpha = 0.5 }");
            terms.push_back({number(digits_of(*t->get("rho"))), number(digits_of(*t->get("alpha")))});
            if (not(terms.back().alpha > 0 and terms.back().alpha < 2)) refuse(t->get("alpha"), "alpha lies between 0 and 2");
        }
        return terms;
    }
    void initial(stated_problem& what) {
        auto const* given = required("initial").as_table();
        if (given == nullptr) refuse(&required("initial"), "initial values are a table, as { q = 1, v = 0 }");
        std::size_t used = 0;
        auto const take = [&](named const& names, std::vector<std::string>& to) {
            for (auto const& [name, size] : names) {
                auto const* n = given->get(name);
                if (n == nullptr) refuse(given, "the initial values have no '" + name + "'");
                auto const digits = n->is_array() ? digits_of_list(*n, "numbers") : std::vector{digits_of(*n)};
                if (digits.size() != static_cast<std::size_t>(std::max(size, 1)))
                    refuse(n, "'" + name + "' has " + std::to_string(std::max(size, 1)) + " initial values, and here are " +
                                  std::to_string(digits.size()));
                to.insert(to.end(), digits.begin(), digits.end());
                ++used;
            }
        };
        take(names_, what.q);
        take(velocities_, what.v);
        if (used != given->size()) refuse(given, "there are initial values of what is no coordinate and no velocity");
    }
    hilger::index_type steps() {
        auto const& n = required("steps");
        auto const count = n.value<std::int64_t>();
        if (not n.is_integer() or *count < 1) refuse(&n, "steps is a positive whole number");
        return static_cast<hilger::index_type>(*count);
    }
    std::string chosen(toml::node const& n, char const* key, std::vector<std::string> const& choices) {
        std::string const name = text_of(n, key).first;
        std::string known;
        for (auto const& c : choices) known += (known.empty() ? "" : ", ") + c;
        if (std::find(choices.begin(), choices.end(), name) == choices.end())
            refuse(&n, "the " + std::string(key) + " is one of " + known + " here, and not '" + name + "'");
        return name;
    }
    /// Columns and pictures.
    void describe(scene& s, stated_problem const& what) const {
        s.columns = {"t"};
        for (bool const momenta : {false, true})
            for (auto const& [name, size] : names_)
                for (int k = 0; k < std::max(size, 1); ++k)
                    s.columns.push_back((momenta ? "p_" : "") + name + (size > 0 ? "_" + std::to_string(k) : ""));
        s.picture = "set title 'Positions'; set xlabel 't'; plot for [k=2:" + std::to_string(1 + std::min(s.dimension, 6)) +
                    "] DATA using 1:k with lines notitle\n";
        if (what.conserves_energy()) {
            s.columns.emplace_back("energy error");
            s.invariants = {"energy"};
            s.picture +=
                "set title 'Energy error'; set xlabel 't'; plot DATA using 1:" + std::to_string(s.columns.size()) + " with lines notitle\n";
        }
    }

    toml::node const& required(char const* key) const {
        auto const* n = file_.get(key);
        if (n == nullptr) hilger::error::raise<hilger::error::unreadable>(path_, ": there is no ", key, ", which a problem has");
        return *n;
    }
    std::pair<std::string, toml::source_position> text_of(toml::node const& n, char const* key) const {
        if (auto const s = n.value_exact<std::string>()) return {*s, n.source().begin};
        refuse(&n, std::string(key) + " is a text, in quotes");
    }
    /// The digits of a number or of a text.
    std::string digits_of(toml::node const& n) const {
        if (auto const x = n.value_exact<std::int64_t>()) return std::to_string(*x);
        if (auto const x = n.value_exact<double>(); x and std::isfinite(*x)) return hilger::round_trip(*x);
        if (auto const s = n.value_exact<std::string>(); s and text::number_in<double>(*s)) return *s;
        refuse(&n, "a number was expected, as 1, 0.5 or \"1/3\"");
    }
    std::vector<std::string> digits_of_list(toml::node const& n, char const* what) const {
        auto const* list = n.as_array();
        if (list == nullptr) refuse(&n, std::string("a list was expected, of ") + what);
        std::vector<std::string> all;
        for (auto const& x : *list) all.push_back(digits_of(x));
        return all;
    }
    static double number(std::string const& digits) { return *text::number_in<double>(digits); }

    template <class Work>
    auto saying_where(toml::node const* n, Work const& work) const -> decltype(work()) {
        try {
            return work();
        } catch (hilger::error::invalid_parameter const& e) {
            refuse(n, e.what());
        } catch (hilger::error::mismatch const& e) {
            refuse(n, e.what());
        }
    }
    [[noreturn]] void refuse(toml::node const* n, std::string const& why) const {
        if (n == nullptr) hilger::error::raise<hilger::error::unreadable>(path_, ": ", why);
        refuse(n->source().begin, why);
    }
    [[noreturn]] void refuse(toml::source_position const& at, std::string const& why) const {
        hilger::error::raise<hilger::error::unreadable>(path_, ", line ", at.line, ", column ", at.column, ": ", why);
    }

    std::string path_;
    toml::table file_;
    named names_, velocities_;
};

} // namespace

scene scene_from_text(std::string_view content, std::string const& path) { return file_reader(content, path).read(); }

scene scene_from_file(std::string const& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream content;
    if (not in or not(content << in.rdbuf())) hilger::error::raise<hilger::error::unreadable>("cannot read a problem from '", path, "'");
    return scene_from_text(content.str(), path);
}

} // namespace program
