#pragma once
#include <brouwer/spelling.hpp>  // messages everywhere need it, not only those of ensembles
