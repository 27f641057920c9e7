#pragma once
#include <string>

#include "analysis/figures/cloud_film.hpp"
#include "analysis/figures/figure_sheet.hpp"

namespace brouwer {

/// Scripts that run as they stand in the folder of cloud.dat.
std::string moving_script(CloudFilm const& film);                      ///< writes cloud.gif
std::string still_script(CloudFilm const& film, FigureFormat format);  ///< writes cloud-still.FORMAT

}  // namespace brouwer
