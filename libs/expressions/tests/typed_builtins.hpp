#pragma once

// Every built-in energy as one would type it.

#include <map>
#include <string>
#include <vector>

namespace isostretch::tests {

struct TypedBuiltin {
  std::string name, text;
  std::map<std::string, double> parameters;  // of both
};

inline const std::vector<TypedBuiltin>& typed_builtins() {
  static const std::vector<TypedBuiltin> all{
      {"arap", "I2 - 2*I1 + d", {}},
      {"arruda_boyce",
       "mu*((I2*J^(-2/d) - d)/2 + ((I2*J^(-2/d))^2 - d^2)/(20*N) + 11*((I2*J^(-2/d))^3 - d^3)/(1050*N^2) +"
       " 19*((I2*J^(-2/d))^4 - d^4)/(7000*N^3) + 519*((I2*J^(-2/d))^5 - d^5)/(673750*N^4)) + K/2*(J - 1)^2",
       {{"mu", 1.3}, {"N", 8}, {"K", 2}}},
      {"conformal_amips_3d", "I2/(3*J^(2/3))", {}},
      {"corotational", "mu*(I2 - 2*I1 + d) + kappa/2*(I1 - d)^2", {{"mu", 1.5}, {"kappa", 0.7}}},
      {"dirichlet", "I2/2", {}},
      {"exponential_amips",
       "exp(sharpness*(alpha*if(d < 3, I2/(2*J), (I2*((I1^2 - I2)^2/4 - 2*I1*J)/J^2 - 1)/8)"
       " + (1 - alpha)*(J + 1/J)/2))",
       {{"sharpness", 2}, {"alpha", 0.4}}},
      {"fixed_corotational", "mu*(I2 - 2*I1 + d) + lambda/2*(J - 1)^2", {{"mu", 1.2}, {"lambda", 3}}},
      {"fung", "mu/(2*b)*expm1(b*(I2*J^(-2/d) - d)) + K/2*(J - 1)^2", {{"mu", 1.1}, {"b", 0.8}, {"K", 2}}},
      {"hencky", "mu*sum(log(s)^2) + lambda/2*log(J)^2", {{"mu", 1.4}, {"lambda", 2}}},
      {"lim_barrier",
       "mu/2*I2 + if(J <= epsilon, 1/0, if(J < epsilon + width, weight*(1/(1 - (1 - (J - epsilon)/width)^3) "
       "- 1), 0))",
       {{"mu", 1.2}, {"weight", 0.8}, {"epsilon", 0}, {"width", 0.9}}},
      {"log_barrier", "-weight*log(J)", {{"weight", 0.7}}},
      {"mips_2d", "I2/J", {}},
      {"mips_3d", "(s1/s2 + s2/s1)*(s2/s3 + s3/s2)*(s3/s1 + s1/s3)/8", {}},
      {"mooney_rivlin_3d",
       "c10*(J^(-2/3)*I2 - 3) + c01*(J^(-4/3)*((I1^2 - I2)^2/4 - 2*I1*J) - 3) + K/2*(J - 1)^2",
       {{"c10", 0.5}, {"c01", 0.2}, {"K", 3}}},
      {"neo_hookean_log", "mu/2*(I2 - d) - mu*log(J) + lambda/2*log(J)^2", {{"mu", 1.2}, {"lambda", 4}}},
      {"st_venant_kirchhoff", "mu/4*sum((s^2 - 1)^2) + kappa/8*(I2 - d)^2", {{"mu", 1.1}, {"kappa", 2}}},
      {"stable_neo_hookean", "mu/2*(I2 - d) - mu*(J - 1) + lambda/2*(J - 1)^2", {{"mu", 1.2}, {"lambda", 5}}},
      {"stable_neo_hookean_log",
       "mu/2*(I2 - d) + lambda/2*(J - 1 - mu/lambda*d/(d + 1))^2 - mu/2*log(I2 + 1)",
       {{"mu", 1.2}, {"lambda", 5}}},
      {"symmetric_arap", "mu/2*sum((s - 1)^2 + (1/s - 1)^2)", {{"mu", 0.8}}},
      {"symmetric_dirichlet", "weight*sum(s^2 + 1/s^2)", {{"weight", 0.6}}},
      {"symmetric_gradient", "I2/2 - log(J)", {}},
      {"volume_quadratic", "weight*(J - 1)^2", {{"weight", 1.7}}},
      {"volume_symmetric", "weight*(J + 1/J - 2)/2", {{"weight", 1.7}}},
  };
  return all;
}

}  // namespace isostretch::tests
