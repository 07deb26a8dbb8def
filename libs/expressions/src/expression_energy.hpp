#pragma once

#include "program.hpp"

#include <isostretch/energies/any_energy.hpp>

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isostretch::expressions {

class ExpressionEnergy final : public energies::ChunkEnergy {
 public:
  ExpressionEnergy(std::string_view text, const std::map<std::string, double>& parameters);

  std::string name() const override { return text_; }
  bool supports(int dim) const override { return programs_[dim - 2].has_value(); }
  double determinant_bound() const override { return determinant_bound_; }
  bool coupled() const override { return coupled_; }
  std::vector<energies::Parameter> parameters() const override { return parameters_; }
  void psi(int dim, const energies::StretchChunk& chunk) const override;
  void derivatives(int dim, const energies::StretchChunk& chunk) const override;

 private:
  struct Programs {
    Program psi, derivatives;
    std::optional<Program>
        psi_near_rest;         // by differences from rest; none where the energy is not finite there
    bool by_partials = false;  // derivatives are partials by invariants
    bool coupled = true;       // A has off-diagonal entries
    bool ends_at_zero = false;
  };
  void replace_psi_near_rest(int dim, const energies::StretchChunk& chunk) const;
  std::optional<Programs> programs_for(int dim, const std::map<std::string, double>& parameters) const;
  void require_used(const std::map<std::string, double>& parameters) const;

  std::string text_;
  std::vector<energies::Parameter> parameters_;
  double determinant_bound_;
  bool coupled_ = false;
  std::optional<Programs> programs_[2];
};

}  // namespace isostretch::expressions
