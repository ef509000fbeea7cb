#pragma once

#include <CLI/CLI.hpp>
#include <optional>

namespace gable {

/// Adds --spread to a command.
inline void add_spread_option(CLI::App* command, std::optional<double>* spread) {
  command
      ->add_option("--spread", *spread,
                   "Width that every surface height is a mean over, 0 where each is that of one "
                   "surface; told by how walls are smeared unless given")
      ->type_name("METRES")
      ->check(CLI::Range(0.0, 100.0));
}

}  // namespace gable
