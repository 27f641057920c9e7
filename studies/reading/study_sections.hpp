#pragma once
#include <brouwer/ensemble/catalogue.hpp>
#include <brouwer/ensemble/study.hpp>

#include "studies/reading/section.hpp"

namespace brouwer {

// Each of these reads one table of a study file into `study`; complaints go to the section's Reading.

/// [system.NAME]. Returns null where there is no such system; nothing else can be judged then.
SystemDescription const* read_system(Section& root, Catalogue const& catalogue, Study& study);
void read_integrate(Section& root, Catalogue const& catalogue, Study& study);
void read_ensemble(Section& root, SystemDescription const& system, Study& study);
void read_observe(Section& root, Catalogue const& catalogue, SystemDescription const& system, Study& study);

/// All of them, in this order, and what must hold between them.
void read_study_sections(Section& root, Catalogue const& catalogue, Study& study);

}  // namespace brouwer
