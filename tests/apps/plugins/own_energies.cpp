// A plug-in as a user writes it: symmetric Dirichlet, an energy with a parameter, and a function of
// stretches.
#include <isostretch/energies/plugin.hpp>

struct MySymmetricDirichlet {
  static constexpr const char* name = "my_symmetric_dirichlet";
  static constexpr double minimum_determinant = 0.0;
  static constexpr bool supports(int dim) { return dim == 2; }

  template <int Dim, class T>
  T psi(const isostretch::energies::Invariants<Dim, T>& I) const {
    return I.I2 + I.I2 / (I.I3 * I.I3);
  }
};

struct MyNeoHookean {
  static constexpr const char* name = "my_neo_hookean";
  static constexpr double minimum_determinant = 0.0;
  double bulk = 1.0;

  template <class Visitor>
  void parameters(Visitor&& visit) {
    visit("bulk", bulk, "resistance to change of volume");
  }

  template <int Dim, class T>
  T psi(const isostretch::energies::Invariants<Dim, T>& I) const {
    using isostretch::log;
    const T L = log(I.I3);
    return 0.5 * I.I2 - L + 0.5 * bulk * L * L;
  }
};

struct MyHencky {
  static constexpr const char* name = "my_hencky";
  static constexpr bool of_stretches = true;
  static constexpr double minimum_determinant = 0.0;

  template <class... T>
  auto operator()(T... s) const {
    using isostretch::log;
    using isostretch::square;
    return (square(log(s)) + ...);
  }
};

ISOSTRETCH_ENERGY_PLUGIN(MySymmetricDirichlet, MyNeoHookean, MyHencky)
