// SPDX-License-Identifier: BSL-1.0
// As compiled_once.hpp, what reads formulas; for who names something of their own `text` apart from it.
#pragma once

#include "compiled_once.hpp"
#include "hilger/text/stated_embedding.hpp"
#include "hilger/text/vocabulary.hpp"

#define HILGER_TEXTS(how)                                                                                                                  \
    namespace hilger::text {                                                                                                               \
    how template std::optional<double> number_in(std::string_view);                                                                        \
    how template std::optional<float50> number_in(std::string_view);                                                                       \
    how template std::optional<float100> number_in(std::string_view);                                                                      \
    namespace detail {                                                                                                                     \
    how template std::optional<std::vector<Q>> exact_row_of<Q>(operator_formula const&, bool, lost_points);                                \
    how template bool equal_rows<float50>(operator_formula const&, operator_formula const&, bool, lost_points);                            \
    how template hilger::detail::consistency consistency_of(embedding_formula const&, Q const&);                                           \
    }                                                                                                                                      \
    }

HILGER_TEXTS(extern)
