// SPDX-License-Identifier: BSL-1.0
#include <unordered_set>

#include "text/evaluate.hpp"

namespace hilger::text {

stated::stated(expression what, std::shared_ptr<vocabulary const> words, std::string source)
    : what_(std::move(what)), words_(std::move(words)), source_(std::move(source)) {
    double const time = 1;
    auto const one = [](int) { return 1.0; };
    detail::evaluator<double> everywhere(*words_, source_, time, one, one, true);
    everywhere.value(what_.root());
    operations_ = everywhere.operations();
}
bool stated::reads(meaning::role role) const {
    std::vector<node const*> open{&what_.root()};
    std::unordered_set<node const*> seen;
    while (not open.empty()) {
        node const& n = *open.back();
        open.pop_back();
        if (not seen.insert(&n).second) continue;
        if (n.what == kind::name or n.what == kind::element)
            if (meaning const* m = words_->find(n.name); m != nullptr and m->is == role) return true;
        for (auto const& part : n.parts) open.push_back(part.get());
    }
    return false;
}

} // namespace hilger::text
