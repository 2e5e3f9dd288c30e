// Fits of models to data: the PALMER problems of CUTEst (measured energies of rotation, Palmer; nonnegative parameters
// from 1e-5), WEEDS, Kowalik and Osborne, Meyer, and a sum of exponentials to generated data.
#include <cstdlib>
#include <memory>
#include <utility>

#include "bound_dual.h"

namespace orbicube::bench {
namespace {

using std::vector;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

struct Data {
  vector<double> x, y;
};

// Each pair at x and at -x, but for x = 0.
Data both_sides(const vector<std::pair<double, double>>& half) {
  Data data;
  for (const auto& [x, y] : half) {
    data.x.push_back(x);
    data.y.push_back(y);
    if (x == 0) continue;
    data.x.push_back(-x);
    data.y.push_back(y);
  }
  return data;
}

Data one_side(const vector<std::pair<double, double>>& half) {
  Data data;
  for (const auto& [x, y] : half) {
    data.x.push_back(x);
    data.y.push_back(y);
  }
  return data;
}

// H-N=N=N
const vector<std::pair<double, double>> azide = {
    {1.788963, 78.596218}, {1.745329, 65.77963}, {1.658063, 43.96947}, {1.570796, 27.038816},
    {1.483530, 14.6126},   {1.396263, 6.2614},   {1.308997, 1.538330}, {1.218612, 0.000000},
    {1.134464, 1.188045},  {1.047198, 4.6841},   {0.872665, 16.9321},  {0.698132, 33.6988},
    {0.523599, 52.3664},   {0.349066, 70.1630},  {0.174533, 83.4221},  {0.0, 88.3995}};
const vector<std::pair<double, double>> azide_ends = {{1.8762289, 108.18086}, {1.8325957, 92.733676}};
// H-N=C=O
const vector<std::pair<double, double>> cyanate = {{1.745329, 72.676767}, {1.570796, 40.149455}, {1.396263, 18.8548},
                                                   {1.221730, 6.4762},    {1.047198, 0.8596},    {0.937187, 0.0},
                                                   {0.872665, 0.2730},    {0.698132, 3.2043},    {0.523599, 8.1080},
                                                   {0.349066, 13.4291},   {0.174533, 17.7149},   {0.0, 19.4529}};
// H-N=C=Se, two levels of theory
const vector<std::pair<double, double>> selenide = {
    {0.0, 83.57418},       {1.570796, 81.007654}, {1.396263, 18.983286}, {1.308997, 8.051067},
    {1.221730, 2.044762},  {1.125835, 0.0},       {1.047198, 1.170451},  {0.872665, 10.479881},
    {0.698132, 25.785001}, {0.523599, 44.126844}, {0.349066, 62.822177}, {0.174533, 77.719674}};
const vector<std::pair<double, double>> selenide_other = {
    {0.0, 4.419446},       {0.139626, 3.564931},  {0.261799, 2.139067},  {0.436332, 0.404686}, {0.565245, 0.0},
    {0.512942, 0.035152},  {0.610865, 0.146813},  {0.785398, 2.718058},  {0.959931, 9.474417}, {1.134464, 26.132221},
    {1.308997, 41.451561}, {1.483530, 72.283164}, {1.658063, 117.630959}};

enum class Tail { quotient, scaled_quotient, bell };

// The sum of squares of `powers` even powers of x from `first` on (or Chebyshev polynomials), and a tail, minus y.
Dual palmer(const Duals& a, const Data& data, int first, std::size_t powers, bool chebyshev, Tail tail) {
  Dual sum;
  for (std::size_t i = 0; i < data.x.size(); ++i) {
    const double x = data.x[i], square_x = x * x;
    Dual r(-data.y[i]);
    for (std::size_t k = 0; k < powers; ++k) {
      const double degree = first + 2.0 * static_cast<double>(k);
      const double basis = chebyshev ? std::cos(degree * std::acos(x / 1.570796)) : std::pow(square_x, degree / 2);
      r += basis * a[k];
    }
    if (tail == Tail::quotient) r += a[powers] / (a[powers + 1] + square_x);
    if (tail == Tail::scaled_quotient) r += a[powers] / (a[powers + 1] + square_x / a[powers + 2]);
    if (tail == Tail::bell) r += a[powers] * exp(-square_x * a[powers + 1]);
    sum += square(r);
  }
  return sum;
}

struct Fit {
  const char* name;
  double optimum;
  const Data* data;
  int first;           // degree
  std::size_t powers;  // terms
  bool chebyshev;
  Tail tail;
  vector<double> start = {};  // ones where it is empty
};

BoundProblem make_palmer(const Fit& fit) {
  const std::size_t n = fit.powers + (fit.tail == Tail::scaled_quotient ? 3 : 2);
  const vector<double> start = fit.start.empty() ? vector<double>(n, 1.0) : fit.start;
  vector<double> lower(n, -infinity);
  if (fit.tail == Tail::bell) {
    lower[n - 1] = 0;
  } else {
    for (std::size_t k = fit.powers; k < n; ++k)
      lower[k] = 1e-5;
    if (fit.chebyshev) lower[fit.powers] = 0;
  }
  const auto data = std::make_shared<Data>(*fit.data);
  return dual_problem(fit.name, start, lower, vector<double>(n, infinity), fit.optimum,
                      [=](const Duals& a) { return palmer(a, *data, fit.first, fit.powers, fit.chebyshev, fit.tail); });
}

void add_palmer(std::vector<BoundProblemMaker>& list) {
  static const Data azide_31 = both_sides(azide);
  static const Data azide_35 = [] {
    Data all = azide_31;
    const Data ends = both_sides(azide_ends);
    all.x.insert(all.x.end(), ends.x.begin(), ends.x.end());
    all.y.insert(all.y.end(), ends.y.begin(), ends.y.end());
    return all;
  }();
  static const Data cyanate_23 = both_sides(cyanate), selenide_12 = one_side(selenide),
                    selenide_13 = one_side(selenide_other);
  static const Fit fits[] = {
      {"PALMER1", 1.1754603e4, &azide_31, 2, 1, false, Tail::scaled_quotient},
      {"PALMER1A", 8.9883058e-2, &azide_35, 0, 4, false, Tail::quotient},
      {"PALMER1B", 3.4473495, &azide_35, 2, 2, false, Tail::quotient},
      {"PALMER1E", 8.3523216e-4, &azide_35, 0, 6, false, Tail::bell},
      {"PALMER2", 3.6510975e3, &cyanate_23, 2, 1, false, Tail::scaled_quotient},
      {"PALMER2A", 1.7109717e-2, &cyanate_23, 0, 4, false, Tail::quotient},
      {"PALMER2B", 6.2326690e-1, &cyanate_23, 2, 2, false, Tail::quotient},
      {"PALMER2E", 2.0650379e-4, &cyanate_23, 0, 6, false, Tail::bell},
      {"PALMER5A", unknown, &selenide_12, 0, 6, true, Tail::quotient},
      {"PALMER5B", 9.7524231e-3, &selenide_12, 0, 7, false, Tail::quotient},
      {"PALMER5E",
       unknown,
       &selenide_12,
       0,
       6,
       true,
       Tail::bell,
       {19.264, -1.7302, 40.794, 0.83021, 3.7090, -0.17723, 1, 10}},
      {"PALMER7A", 1.0334910e1, &selenide_13, 0, 4, false, Tail::quotient},
      {"PALMER7E", 1.0153900e1, &selenide_13, 0, 6, false, Tail::bell},
  };
  for (const Fit& fit : fits)
    list.push_back([&fit] { return make_palmer(fit); });
}

// A model with a pole, fitted to a value, a slope and a second derivative.
Dual pole(const Duals& x, const double* data) {
  const Dual &a = x[0], &r = x[1], &h = x[2];
  const Dual logarithm = log(1.0 + h);
  const Dual linear = a * r * h, quadratic = a * (a + 1.0) * r * h * h;
  const Dual value = r * (1.0 - exp(-a * logarithm)), slope = linear * (1.0 - exp(-(a + 1.0) * logarithm));
  const Dual second = quadratic * (1.0 - exp(-(a + 2.0) * logarithm));
  return square(linear - 0.5 * quadratic - value - data[0]) + square(slope - quadratic - data[1]) +
         square(-second - data[2]);
}

void add_poles(std::vector<BoundProblemMaker>& list) {
  static const double data[4][3] = {{-8, -18.66666666, -23.11111111},
                                    {-26.66666666, -60.44444444, -71.11111111},
                                    {-56.88888888, -126.2222222, -143.4074074},
                                    {-98.96296296, -216.0987654, -239.6707818}};
  for (int k = 0; k < 4; ++k) {
    list.push_back([k] {
      return dual_problem("PFIT" + std::to_string(k + 1) + "LS", {1, 0, 1}, {-infinity, -infinity, -0.5},
                          vector(3, infinity), 0, [k](const Duals& x) { return pole(x, data[k]); });
    });
  }
}

// Rheinboldt's semiconductor: potentials at inner nodes and both ends, by differences, as least squares.
Dual semiconductor(const Duals& u) {
  constexpr double length = 1e-4, beta = 40, low = 0, high = 700;
  const std::size_t nodes = u.size() - 2, negative = nodes * 9 / 10;
  const double step = length / static_cast<double>(nodes + 1);
  const double few = 1e12 * step * step, many = 1e13 * step * step;
  Dual sum;
  for (std::size_t i = 1; i <= nodes; ++i) {
    Dual r = u[i - 1] - 2.0 * u[i] + u[i + 1] - (i <= negative ? few : -many);
    r += few * exp(-beta * (u[i] - low));
    r = r - many * exp(beta * (u[i] - high));
    sum += square(r);
  }
  return sum;
}

Dual weeds(const Duals& b) {
  constexpr double y[] = {5.308, 7.24, 9.638, 12.866, 17.069, 23.192, 31.443, 38.558, 50.156, 62.948, 75.995, 91.972};
  Dual sum;
  for (int i = 0; i < 12; ++i)
    sum += square(b[0] / (1.0 + b[1] * exp(-(i + 1.0) * b[2])) - y[i]);
  return sum;
}

Dual kowalik_osborne(const Duals& x) {
  constexpr double y[] = {0.1957, 0.1947, 0.1735, 0.1600, 0.0844, 0.0627, 0.0456, 0.0342, 0.0323, 0.0235, 0.0246};
  constexpr double u[] = {4, 2, 1, 0.5, 0.25, 0.167, 0.125, 0.1, 0.0833, 0.0714, 0.0625};
  Dual sum;
  for (int i = 0; i < 11; ++i)
    sum += square(y[i] - x[0] * (u[i] * u[i] + u[i] * x[1]) / (u[i] * u[i] + u[i] * x[2] + x[3]));
  return sum;
}

// Meyer's fit to a thermistor, in scaled parameters (x1 in hundredths, x2 and x3 in thousands and hundreds).
Dual scaled_meyer(const Duals& x) {
  constexpr double y[] = {34780, 28610, 23650, 19630, 16370, 13720, 11540, 9744,
                          8261,  7030,  6005,  5147,  4427,  3820,  3307,  2872};
  Dual sum;
  for (int i = 0; i < 16; ++i) {
    const double t = 45 + 5 * (i + 1);
    sum += square(1e-2 * x[0] * exp(1e3 * x[1] / (t + 100.0 * x[2])) - y[i]);
  }
  return 1e-6 * sum;
}

// Two decaying exponentials, nonnegative, to generated data with an error of one in a thousand.
Dual exponentials(const Duals& x) {
  Dual sum;
  for (int i = 0; i < 60; ++i) {
    const double t = 0.05 * i;
    const double y = (2 * std::exp(-1.1 * t) + std::exp(-2.3 * t)) * (1 + 1e-3 * std::sin(37.0 * i * i));
    sum += square(x[0] * exp(-x[1] * t) + x[2] * exp(-x[3] * t) - y);
  }
  return sum;
}

}  // namespace

void add_fits(std::vector<BoundProblemMaker>& list) {
  add_palmer(list);
  add_poles(list);
  list.push_back([] {
    vector<double> start(12, 0.0), lower(12, -5.0), upper(12, 705.0);
    lower[0] = upper[0] = 0;
    start[11] = lower[11] = upper[11] = 700;
    BoundProblem p = dual_problem("SCOND1LS", start, lower, upper, 0, semiconductor);
    // Curvatures of 1e9 at potentials of 700, which are rounded by 1e-13.
    p.tolerance = 1e-3;
    return p;
  });
  list.push_back([] {
    return dual_problem("WEEDS", {1, 1, 1}, vector(3, -infinity), {infinity, infinity, 3}, unknown, weeds);
  });
  list.push_back([] {
    return dual_problem("Kowalik and Osborne, x >= 0.1", {0.25, 0.39, 0.415, 0.39}, vector(4, 0.1), vector(4, 0.42),
                        unknown, kowalik_osborne);
  });
  list.push_back([] {
    return dual_problem("Meyer, scaled, x3 <= 3.4", {2, 4, 2.5}, vector(3, 0.0), {infinity, infinity, 3.4}, unknown,
                        scaled_meyer);
  });
  list.push_back([] {
    return dual_problem("two exponentials, generated", {1, 1, 1, 5}, vector(4, 0.0), vector(4, infinity), unknown,
                        exponentials);
  });
}

}  // namespace orbicube::bench
