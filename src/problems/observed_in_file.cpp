// SPDX-License-Identifier: BSL-1.0
// Observed quantities of a problem in TOML, beside t, positions and momenta, and the reference for its errors:
//   units = "s"                                                            of the interval
//   conserved = { "angular momentum" = "x*v_y - y*v_x" }                   formulas whose change is a column, as the energy's is
//   observed = { height = "-l*cos(q)" }                                    formulas that are columns
//   pictures = [ { title = "Path", x = "x", y = "y", equal = true } ]      columns by their names; y and x may be lists; x defaults to t
//   reference = { embedding = "gauss-8", steps = 4000 }                    a run to its end, the reference of `hilger trade`, or
//   exact = { position = ["0.5", "1/3"], source = "...", error = 1e-30 }   the position at the end of the interval
// Nothing in it is executed: only names and titles of a picture come from the file, in single quotes, where gnuplot substitutes nothing.
#include "parts_of_file.hpp"

#include <algorithm>
#include <array>

namespace program {

namespace {

namespace text = hilger::text;

class observation_reader {
public:
    observation_reader(toml_file const& file, std::shared_ptr<text::vocabulary const> words, scene& s)
        : file_(file), words_(std::move(words)), s_(s) {}

    void formulas(char const* key, std::vector<named_formula>& to) const {
        auto const* given = file_.get(key);
        if (given == nullptr) return;
        std::string const as = std::string(key) + " is a table of formulas, as { height = \"-cos(q)\" }";
        for (auto const& [name, node] : file_.table_of(*given, as))
            to.push_back({file_.heading(name.source().begin, std::string(name.str())), file_.formula(node, words_, key)});
    }
    void pictures() const {
        auto const* given = file_.get("pictures");
        if (given == nullptr) return usual_pictures();
        auto const* list = given->as_array();
        if (list == nullptr or list->empty() or list->size() > 2)
            file_.refuse(given, "pictures are a list of one or two, as [ { title = \"Path\", x = \"x\", y = \"y\" } ]");
        s_.picture.clear();
        for (auto const& n : *list) {
            auto const& one = file_.table_of(n, "a picture is { title = \"Path\", x = \"x\", y = \"y\" }");
            file_.require_known(one, std::array<std::string_view, 4>{"title", "x", "y", "equal"});
            auto const* y = one.get("y");
            if (y == nullptr) file_.refuse(&n, "a picture has a y, the name of a column or a list of such");
            std::vector<toml::node const*> curves;
            if (auto const* names = y->as_array())
                for (auto const& name : *names) curves.push_back(&name);
            else
                curves.push_back(y);
            if (curves.empty()) file_.refuse(y, "a picture has a y, the name of a column or a list of such");
            std::vector<toml::node const*> abscissas;
            if (auto const* x = one.get("x")) {
                if (auto const* names = x->as_array())
                    for (auto const& name : *names) abscissas.push_back(&name);
                else
                    abscissas.push_back(x);
                if (abscissas.size() != 1 and abscissas.size() != curves.size())
                    file_.refuse(x, "x is the name of a column, or a list of as many as y has");
            }
            bool equal = false;
            if (auto const* e = one.get("equal")) {
                if (not e->is_boolean()) file_.refuse(e, "equal is true or false: whether x and y have one scale");
                equal = *e->value<bool>();
            }
            auto const* title = one.get("title");
            std::vector<std::size_t> columns, by;
            for (auto const* c : curves) columns.push_back(column(*c, "y"));
            for (auto const* c : abscissas) by.push_back(column(*c, "x"));
            if (by.empty()) by.push_back(0);
            plot(title != nullptr ? file_.heading(title->source().begin, file_.text_of(*title, "title")) : "", by, columns, equal);
        }
    }
    void measure() const {
        s_.reference = s_.usual;
        if (std::find(s_.embeddings.begin(), s_.embeddings.end(), "gauss-8") != s_.embeddings.end()) s_.reference.embedding = "gauss-8";
        if (auto const* given = file_.get("reference")) {
            auto const& r = file_.table_of(*given, "a reference is { embedding = \"gauss-8\", steps = 1000 }");
            file_.require_known(r, std::array<std::string_view, 4>{"embedding", "scalar", "history", "steps"});
            if (auto const* n = r.get("embedding")) s_.reference.embedding = file_.chosen(*n, "embedding", s_.embeddings);
            if (auto const* n = r.get("scalar")) s_.reference.scalar = file_.chosen(*n, "scalar", s_.scalars);
            if (auto const* n = r.get("history")) s_.reference.history = file_.chosen(*n, "history", s_.histories);
            if (auto const* n = r.get("steps")) s_.reference.steps = file_.count_of(*n, "steps");
        }
        if (auto const* given = file_.get("exact")) {
            auto const& e = file_.table_of(*given, "what is exact is { position = [\"0.5\"], source = \"...\", error = 1e-30 }");
            file_.require_known(e, std::array<std::string_view, 3>{"position", "source", "error"});
            auto const* p = e.get("position");
            if (p == nullptr) file_.refuse(given, "what is exact has a position, a list of numbers at the end of the interval");
            auto const digits = file_.digits_of_list(*p, "numbers");
            if (digits.size() != static_cast<std::size_t>(s_.dimension))
                file_.refuse(p,
                             "a position has " + std::to_string(s_.dimension) + " numbers, and here are " + std::to_string(digits.size()));
            auto const* error = e.get("error");
            s_.exact_error = error != nullptr ? file_.number(file_.digits_of(*error)) : 1e-15;
            if (not(s_.exact_error >= 0)) file_.refuse(error, "the error of what is exact is not negative");
            auto const* source = e.get("source");
            s_.exact_source = source != nullptr ? file_.text_of(*source, "source") : "what " + file_.path() + " says";
            s_.exact = [digits] {
                std::vector<hilger::float100> x;
                for (auto const& d : digits) x.push_back(*text::number_in<hilger::float100>(d));
                return x;
            };
        }
    }

private:
    void usual_pictures() const {
        std::vector<std::size_t> positions;
        for (int k = 1; k <= std::min(s_.dimension, 6); ++k) positions.push_back(static_cast<std::size_t>(k));
        plot("Positions", {0}, positions, false);
        for (std::size_t k = 0; k < s_.columns.size(); ++k)
            if (s_.columns[k] == "energy error") plot("Energy error", {0}, {k}, false);
    }
    [[nodiscard]] std::size_t column(toml::node const& n, char const* key) const {
        std::string const name = file_.text_of(n, key);
        auto const at = std::find(s_.columns.begin(), s_.columns.end(), name);
        if (at != s_.columns.end()) return static_cast<std::size_t>(at - s_.columns.begin());
        std::string known;
        for (auto const& c : s_.columns) known += (known.empty() ? "" : ", ") + c;
        file_.refuse(&n, "there is no column '" + name + "': there are " + known);
    }
    /// One plot, by gnuplot's column numbers, from 1; all y over one x, or each over its own.
    void plot(std::string const& title, std::vector<std::size_t> const& x, std::vector<std::size_t> const& y, bool equal) const {
        std::string const units = x[0] == 0 and not s_.units.empty() ? " / " + s_.units : "";
        // Not enhanced: otherwise q_12 would become q with the index 1, and a 2.
        s_.picture += "set key noenhanced; set title '" + title + "' noenhanced; set size " + (equal ? "ratio -1" : "noratio") +
                      "; set xlabel '" + (x.size() == 1 ? s_.columns[x[0]] : "") + units + "' noenhanced; set ylabel '" +
                      (y.size() == 1 ? s_.columns[y[0]] : "") + "' noenhanced\nplot ";
        for (std::size_t k = 0; k < y.size(); ++k)
            s_.picture += (k == 0 ? "<rows> using " : ", <rows> using ") + std::to_string(x[x.size() == 1 ? 0 : k] + 1) + ':' +
                          std::to_string(y[k] + 1) + " with lines " + (y.size() == 1 ? "notitle" : "title '" + s_.columns[y[k]] + "'");
        s_.picture += '\n';
    }
    toml_file const& file_;
    std::shared_ptr<text::vocabulary const> words_;
    scene& s_;
};

} // namespace

void observe(toml_file const& file, std::shared_ptr<text::vocabulary const> const& words, stated_problem& what, scene& s) {
    observation_reader const reader(file, words, s);
    if (auto const* units = file.get("units")) s.units = file.heading(units->source().begin, file.text_of(*units, "units"));
    reader.formulas("conserved", what.conserved);
    reader.formulas("observed", what.observed);
    if (not what.last.empty())
        for (char const* key : {"conserved", "observed"})
            for (auto const& f : *key == 'c' ? what.conserved : what.observed)
                if (*key == 'c' or f.of.reads(text::meaning::role::velocity))
                    file.refuse(file.get(key),
                                "between two ends positions are found: what is observed reads no velocities, and nothing is conserved");
    if (what.conserves_energy() and what.last.empty()) s.invariants = {"energy"};
    for (auto const& f : what.conserved) s.invariants.push_back(f.name);
    auto const add = [&](std::string const& column, char const* key) {
        if (std::find(s.columns.begin(), s.columns.end(), column) != s.columns.end())
            file.refuse(file.get(key), "there is a column '" + column + "' already");
        s.columns.push_back(column);
    };
    for (auto const& name : s.invariants) add(name + " error", "conserved");
    for (auto const& f : what.observed) add(f.name, "observed");
    reader.pictures();
    reader.measure();
}

} // namespace program
