#pragma once
#include "fitting/eos/list.hpp"
#include <array>
#include <optional>
#include <string_view>

namespace mesobridge::fitting {

/// One number of a model file: its key, with the unit in it, and where it goes.
template <class Parameters>
struct FileKey {
  std::string_view name;
  double Parameters::*member;
  std::optional<double> if_missing = std::nullopt; ///< for keys that older files do not have
};

/// How a model that is a plain struct of numbers stands in a file: `kind = "..."` and one table of keys.
template <class Model>
struct FileForm;

template <>
struct FileForm<MieGruneisen> {
  using P = MieGruneisenParameters;
  static constexpr std::string_view kind = "mie-gruneisen", table = "mie_gruneisen";
  static constexpr std::array<FileKey<P>, 11> keys{{{"Gamma_0", &P::Gamma_0},
                                                    {"Gamma_inf", &P::Gamma_inf},
                                                    {"q", &P::q},
                                                    {"rho_0_kg_m3", &P::rho_0},
                                                    {"Theta_0_K", &P::Theta_0},
                                                    {"u_r", &P::u_r},
                                                    {"c_v_J_kg_K", &P::c_v},
                                                    {"rho_s_kg_m3", &P::rho_s},
                                                    {"K_s_Pa", &P::K_s},
                                                    {"N_s", &P::N_s},
                                                    {"m0_kg", &P::m0}}};
};

template <>
struct FileForm<Hz> {
  using P = HzParameters;
  static constexpr std::string_view kind = "hz", table = "hz";
  static constexpr std::array<FileKey<P>, 8> keys{{{"Gamma_0", &P::Gamma_0},
                                                   {"rho_0_kg_m3", &P::rho_0},
                                                   {"c_0_m_s", &P::c_0},
                                                   {"s", &P::s},
                                                   {"c_v_J_kg_K", &P::c_v},
                                                   {"T_0_K", &P::T_0},
                                                   {"P_0_Pa", &P::P_0},
                                                   {"m0_kg", &P::m0}}};
};

template <>
struct FileForm<Jwl> {
  using P = JwlParameters;
  static constexpr std::string_view kind = "jwl", table = "jwl";
  static constexpr std::array<FileKey<P>, 12> keys{{{"Gamma_0", &P::Gamma_0},
                                                    {"rho_0_kg_m3", &P::rho_0},
                                                    {"E_0_J_kg", &P::E_0},
                                                    {"D_CJ_m_s", &P::D_CJ},
                                                    {"P_CJ_Pa", &P::P_CJ},
                                                    {"T_CJ_K", &P::T_CJ},
                                                    {"c_v_J_kg_K", &P::c_v},
                                                    {"a_Pa", &P::a},
                                                    {"b_Pa", &P::b},
                                                    {"R_1", &P::R_1},
                                                    {"R_2", &P::R_2},
                                                    {"m0_kg", &P::m0}}};
};

template <>
struct FileForm<StiffenedGas> {
  using P = StiffenedGasParameters;
  static constexpr std::string_view kind = "stiffened-gas", table = "stiffened_gas";
  static constexpr std::array<FileKey<P>, 6> keys{{{"gamma", &P::gamma},
                                                   {"P_inf_Pa", &P::P_inf},
                                                   {"c_v_J_kg_K", &P::c_v},
                                                   {"q_J_kg", &P::q},
                                                   {"m0_kg", &P::m0},
                                                   {"b_m3_kg", &P::b, 0.0}}};
};

/// A model that has a FileForm.
template <class Model>
concept ParametricModel = requires {
  FileForm<Model>::kind;
};

} // namespace mesobridge::fitting
