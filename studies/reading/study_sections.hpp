#pragma once
#include <brouwer/ensemble/catalogue.hpp>
#include <brouwer/ensemble/study.hpp>

#include "studies/reading/section.hpp"

namespace brouwer {

/// Reads everything but the expectations into `study`; every complaint goes to the section's Reading. Where the
/// system itself is missing or unknown, nothing else can be judged and the rest is left unread.
void read_study_sections(Section& root, Catalogue const& catalogue, Study& study);

}  // namespace brouwer
