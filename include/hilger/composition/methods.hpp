// SPDX-License-Identifier: BSL-1.0
// Parts c_1, ..., c_s of a step over which a symmetric flow of order 2 becomes one of order 4, 6 or 8: compose(kahan_li<8>, embed(L,
// mid_point)), compose(suzuki_umeno<8>, stoermer_verlet(L)). All are symmetric, c_k = c_{s+1-k}.
//   triple_jump<p>    3 parts   Creutz-Gocksch 1989, Forest 1989, Suzuki 1990, Yoshida 1990   short, with large parts
//   suzuki<p>         5 parts   Suzuki 1990                                                   smaller error for the same work
//   yoshida<6>        7 parts   Yoshida 1990, solution A
//   kahan_li<6>       9 parts   Kahan-Li 1997
//   suzuki_umeno<8>  15 parts   Suzuki-Umeno 1993; McLachlan 1995
//   kahan_li<8>      17 parts   Kahan-Li 1997
// And parts over which any flow and its adjoint become one of order 4: compose_with_adjoint(blanes_moan<4>, embed(L, order_one)).
//   blanes_moan<4>   12 parts   Blanes-Moan 2002, S6   with small errors, and six forces for L = v.Mv/2 - U(q)
// (Hairer-Lubich-Wanner, Geometric Numerical Integration, II.4 and V.3.2.) The published 26 digits were extended to 108 by Newton's method
// on the order conditions: with the steps exp(c h Y_1 + (c h)^3 Y_3 + (c h)^5 Y_5 + ...), every product of Y's of total degree up to p has
// the coefficient that it has in exp(h Y_1). Kahan and Li's have one parameter more than there are conditions: their c_1 is kept as
// published, and so are three of Blanes and Moan's.
#pragma once

#include <cmath>
#include <string_view>

#include "hilger/composition/composition.hpp"

namespace hilger {

namespace detail {

template <class S>
constexpr bool has_roots = std::numeric_limits<S>::is_specialized and not std::numeric_limits<S>::is_exact;

/// c, 1 - n c, c with n outer parts, where c = 1/(n - n^(1/(order - 1))): the error of order `order - 1` cancels.
template <class S>
S outer_part(int n, int order) {
    static_assert(has_roots<S>, "these parts of a step are irrational: they need a floating-point scalar");
    using std::pow;
    return S(1) / (S(n) - S(pow(S(n), S(S(1) / S(order - 1)))));
}

/// The value of "-d.ddd...", digits in groups of nine.
template <class S>
constexpr S decimal(std::string_view digits) {
    bool const negative = digits.front() == '-';
    if (negative) digits.remove_prefix(1);
    S x(0);
    for (std::string_view rest = digits.substr(2); not rest.empty(); rest.remove_suffix(9)) {
        int group = 0;
        for (char const c : rest.substr(rest.size() - 9)) group = 10 * group + (c - '0');
        x = (x + S(group)) / S(1'000'000'000);
    }
    x = x + S(digits.front() - '0');
    return negative ? S(-x) : x;
}

using digits_of_part = std::string_view;

inline constexpr std::array<digits_of_part, 4> yoshida_6{
    "0.784513610477557263819497633866349875776824417451493384567947798951259974795449415499679838778652774929184826",
    "0.235573213359358133684793182978534601686468082103401119003493130956214712152222651578246563027816912387390046",
    "-1.177679984178871006946415680964315734639269252634598484475368513796741556181508926143147863197621127412793541",
    "1.315186320683911218884249728238862514351953506159407961807855167778533738467673718130442922782302880192437337",
};
inline constexpr std::array<digits_of_part, 5> kahan_li_6{
    "0.392161444007314139279250560000000000000000000000000000000000000000000000000000000000000000000000000000000000",
    "0.332599136789359438599748634257274355737334098773451284105993895122643279768464414723057318172769616234198917",
    "-0.706246172557639359809964819634910351039340310785096975025591881622197760327748077619638058081433916192520803",
    "0.082213596293550800231490448853156917696310641537463847393946915426502675830787556558975408020604328284758249",
    "0.798543990934829963398950353048958155211391140948363687051302142146103609456992212675210663776119943347127274",
};
inline constexpr std::array<digits_of_part, 8> suzuki_umeno_8{
    "0.741670364350612953448227801783806315603536510079860590239931751396246213217511098719182496296929735876494098",
    "-0.409100825800031593997300095893563417309917830234813621291561993277128841586357733939324615238218182024044089",
    "0.190754710296238379953876256450371662735460539872510275865233411816103769299771244286856298693712419980363656",
    "-0.573862471116082266656387726635535742159509054333269408558661110356008985581754497854179709176277987083267011",
    "0.299064181303655923844463540688602988225822885294623982746385526195885336032853293902634403731619508258180002",
    "0.334624918245298183784957979882182288633691916310461216537441715803661891337999956315685995816426278841891713",
    "0.315293092396766596632056663811002430994080864717213863445453164920435405011887620918183032662674837938828723",
    "-0.796887939352916354019788840173733053446331663413173797968444932998389575463821964698075805573733223576894185",
};
inline constexpr std::array<digits_of_part, 9> kahan_li_8{
    "0.130202483088890080878817630000000000000000000000000000000000000000000000000000000000000000000000000000000000",
    "0.561162981775108384561964407682000102649863449709010242665473575231835190872017751203666988391172835261686074",
    "-0.389474962644847286408078593043166997128494533168809453036226203346124315097244956136675070713782675250258089",
    "0.158841906555155600896210746677682393213504632244490133487639718215765360127367546259530582478601550868149896",
    "-0.395903894133237577336231543466131671452409608454079979626428334096252117929734479051794708081387316258411472",
    "0.184539640978315707091832543364086516175002388403693537500114920370472488345229208354934074639866674384052268",
    "0.258374387686322047293979111695425973702570489166964789903620302063727644073520739414333271103684377266395179",
    "0.295011723609310298870966236757462976621284831014569542077102288099723352106012530756383335179664789596615657",
    "-0.605508533830034511698921079334718587562643297831677625942592533078295204994336681600756945995640471736459027",
};

inline constexpr std::array<digits_of_part, 6> blanes_moan_4{
    "0.079203696431195700000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000",
    "0.130311410182166300000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000",
    "0.222861495867607700000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000",
    "-0.366713269047425169134513970208481911492218292343651085879701170101373891110613749234471119636733572265394232",
    "0.324648188689705464658597277938807342923318776291035589132959979476018092131922833341654508892692178967993343",
    "0.109688477876750004475916692269674568568899516052615496746741190625355798978690915892816610744041393297400889",
};

} // namespace detail

/// From order p - 2 to order p, for even p: Outer equal steps, half of them before and half after a middle one that goes back in time.
template <int Order, int Outer>
    requires(Order >= 4 and Order % 2 == 0)
struct outer_and_middle_parts {
    static constexpr std::size_t size = Outer + 1;
    template <class S>
    std::array<S, size> values() const {
        std::array<S, size> c;
        c.fill(detail::outer_part<S>(Outer, Order));
        c[Outer / 2] = S(1) - S(Outer) * c[0];
        return c;
    }
};
/// From order Order - 2, by three steps, the middle one backwards.
template <int Order>
inline constexpr outer_and_middle_parts<Order, 2> triple_jump{};
/// From order Order - 2, by five steps, each shorter than the whole.
template <int Order>
inline constexpr outer_and_middle_parts<Order, 4> suzuki{};

/// Parts of order Order from a table, which has those up to the middle.
template <int Order, auto const& Half, std::size_t Middle = 1>
struct tabulated_parts {
    static constexpr std::size_t size = 2 * Half.size() - Middle;
    template <class S>
    std::array<S, size> values() const {
        static_assert(detail::has_roots<S>, "these parts of a step are irrational: they need a floating-point scalar");
        static_assert(std::numeric_limits<S>::digits10 <= 104, "these parts of a step are known to 108 digits");
        // Reading the table would take longer than a run of few steps.
        if constexpr (std::is_floating_point_v<S>) {
            static constexpr std::array<S, size> c = read<S>();
            return c;
        } else
            return read<S>();
    }

private:
    template <class S>
    static constexpr std::array<S, size> read() {
        std::array<S, size> c{};
        for (std::size_t k = 0; k < Half.size(); ++k) c[k] = c[size - 1 - k] = detail::decimal<S>(Half[k]);
        return c;
    }
};

template <int Order>
    requires(Order == 6)
inline constexpr tabulated_parts<6, detail::yoshida_6> yoshida{};
template <int Order>
    requires(Order == 8)
inline constexpr tabulated_parts<8, detail::suzuki_umeno_8> suzuki_umeno{};
template <int Order>
    requires(Order == 6 or Order == 8)
inline constexpr tabulated_parts<6, detail::kahan_li_6> kahan_li{};
template <>
inline constexpr tabulated_parts<8, detail::kahan_li_8> kahan_li<8>{};
template <int Order>
    requires(Order == 4)
inline constexpr tabulated_parts<4, detail::blanes_moan_4, 0> blanes_moan{};

} // namespace hilger
