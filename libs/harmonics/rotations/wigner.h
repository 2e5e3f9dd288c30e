// Wigner's functions d^l_mn(beta), the matrix elements of a rotation by beta about the y axis between the complex
// harmonics of one degree (with the Condon-Shortley phase), and from them those between the real ones.
//
// For each pair m, n they are found in all degrees at once by the recurrence in l of Kostelec and Rockmore (2008, "FFTs
// on the rotation group", eq. 2.5), from d^m_mn = sqrt((2m)! / ((m+n)! (m-n)!)) cos^(m+n)(beta/2) (-sin(beta/2))^(m-n)
// for m >= |n|.
//
// In the real basis a rotation about y does not mix the cosines with the sines. It takes that of order n to the sum
// over m of e_mn (cosines, m >= 0) or o_mn (sines, m >= 1) times that of order m, where
//   e_mn = (-1)^(m+n) d_mn + (-1)^m d_m,-n,   o_mn = (-1)^(m+n) d_mn - (-1)^m d_m,-n   for m, n > 0,
//   e_m0 = (-1)^m sqrt 2 d_m0,  e_00 = d_00,  and e_nm = (-1)^(m+n) e_mn, o_nm = (-1)^(m+n) o_mn.
#pragma once

#include <cstdint>

namespace orbicube::harmonics {

// even[l - m] = e^l_mn and odd[l - m] = o^l_mn for l = m, ..., degree, where 0 <= n <= m. odd is zero for n = 0.
// O(degree - m).
void rotation_about_y(double beta, std::uint32_t m, std::uint32_t n, std::uint32_t degree, double* even, double* odd);

}  // namespace orbicube::harmonics
