// fL of each case of suite.h, frozen: the lowest f that any of the solvers reached in 500 (n + 1) evaluations from
// either start radius (ours and NLopt 2.7.1 BOBYQA).
#pragma once

#include <array>

namespace orbicube::bench {

inline constexpr std::array<double, 92> lowest_suite_values = {
    4.756486131836667e-27,   // Powell badly scaled
    2.3192203713074832e-10,  // Brown badly scaled
    8.3757261745376944e-24,  // Beale
    1.1279327696188879e-08,  // Gaussian
    1.4370281141062289e-29,  // Gulf
    2.2733985212338035e-29,  // Wood
    2.428795485233216e-24,   // Biggs EXP6
    7.0876514670903677e-05,  // penalty I
    9.3762930073554388e-06,  // penalty II
    1.1461678011701614e-20,  // variably dimensioned
    1.7395113938262111e-20,  // trigonometric
    1.6454082783685224e-23,  // boundary value
    6.2141331193272289e-24,  // integral equation
    2.376605004792622e-19,   // Broyden tridiagonal
    1.5036514227474791e-19,  // Broyden banded
    1.0011676569407249e-25,  // extended Rosenbrock
    1.9701973263915537e-37,  // extended Powell
    2.9680891558940569e-29,  // chained Rosenbrock
    5.7967819954504846e-21,  // chained Wood
    8.8170983376553637e-27,  // DENSCHNB
    1.9283959728807633e-24,  // DENSCHNC
    4.3828603914455983e-48,  // DENSCHND
    1.7245659538747533e-22,  // DENSCHNE
    3.2604375900235225e-21,  // DENSCHNF
    8.681858387941328e-20,   // ENGVAL2
    5.1749275382498374e-28,  // Himmelblau
    0.24051059399905814,     // EXPFIT
    7.7804646957569217e-25,  // sine valley
    1.5974284676616498e-22,  // coupled sines
    2.5872773952841648,      // weeds
    7.8469887792975455e-33,  // Hilbert
    1.6577710783410254e-22,  // distances
    0,                       // ARWHEAD
    9.1774699571813869,      // ENGVAL1
    1,                       // DIXMAANA
    1,                       // DIXMAANI
    63.284600105263394,      // EDENSCH
    1.802339087978812e-18,   // LIARWHD
    2.1756365832240806e-19,  // NONDIA
    2.4787637137725439e-19,  // TRIDIA
    1.1063629192655993e-34,  // DQRTIC
    6.870438159855643e-33,   // POWER
    1.239293114628581,       // CRAGGLVY
    1.1035843846293404e-19,  // FLETCHCR
    23.168084197882131,      // NONCVXU2
    -9,                      // COSINE
    -18,                     // SCHMVETT
    4.2194554399686287e-20,  // TQUARTIC
    1.2452600226011963e-20,  // DIXON3DQ
    -0.31049706549265144,    // ALLINITU
    0.20301084473971945,     // BRKMCC, without its pole
    0.19978661367769956,     // CLIFF
    3.8067131268471223e-36,  // SISSER
    20,                      // HAIRY
    -3645.9709888503849,     // MEXHAT, softened
    3.893622088392579e-24,   // HIMMELBG
    -1.0006242206967406,     // MARATOSB, softened
    -18.200000000000014,     // ZANGWIL2
    3.9613618408468626e-20,  // generalized Broyden
    2.36084996651805,        // Toint 7-diagonal
    4.6281347856264814,      // Nazareth trigonometric
    2.1151423377980794,      // boundary energy
    1.8898665961010273,      // repelling points
    0,                       // HS1
    4.9412293179891842,      // HS2
    0,                       // HS3
    2.6666666666666665,      // HS4
    -1.9132229549810367,     // HS5
    9.5280309112969723e-26,  // HS25
    3.8749462020761394e-19,  // HS38
    1.0000000000000002,      // HS45
    -45.778469707446305,     // HS110
    2.690356499366609e-25,   // HATFLDA
    0.0055728090000841234,   // HATFLDB
    6.1464999639665599e-21,  // HATFLDC
    -1.4293067535754411,     // EG1
    0,                       // LOGROS
    -1.0316284534898776,     // CAMEL6
    2.7603675638146812e-48,  // MDHOLE
    2.4142135623730949,      // PSPDOC
    -3.3223680114155147,     // HART6
    -1.0000000000000036,     // S368
    -9.5980061947465138,     // MCCORMCK
    -1.375,                  // torsion
    -0.62176339285714299,    // obstacle
    2.21423444277878e-85,    // BDEXP
    2.4750000000000005,      // CVXBQP1
    -3719.1599999999999,     // NCVXBQP1
    4.02122625168208,        // Rosenbrock chain in a box
    1.811270803709504,       // Broyden in a box
    0.12673355906682557,     // exponentials in a box
    -1.0229786006641592,     // simplex penalty
};

}  // namespace orbicube::bench
