#include <brouwer/store/folder.hpp>

#include <fmt/format.h>
#include <system_error>
#include <unistd.h>

#include <brouwer/error.hpp>
#include <brouwer/store/plan_text.hpp>
#include <brouwer/store/whole_file.hpp>

namespace brouwer {
namespace {

namespace fs = std::filesystem;

char const* const plan_name = "plan.txt";
char const* const study_name = "study.toml";
char const* const provenance_name = "provenance.txt";
char const* const units_name = "units";

bool has_plan(fs::path const& folder) {
  std::error_code none;
  return fs::is_regular_file(folder / plan_name, none);
}

/// A run that was killed before it wrote plan.txt leaves nothing but an empty units/ and what is rewritten.
bool is_unfinished(fs::path const& folder) {
  if (!fs::is_directory(folder / units_name)) return false;
  for (auto const& entry : fs::directory_iterator(folder)) {
    auto const name = entry.path().filename();
    if (name != units_name && name != study_name && name != provenance_name && !is_leftover(name)) return false;
  }
  for (auto const& entry : fs::recursive_directory_iterator(folder / units_name))
    if (!entry.is_directory()) return false;
  return true;
}

void refuse_foreign(fs::path const& folder) {
  if (!fs::exists(folder)) return;
  if (!fs::is_directory(folder)) throw InputError(fmt::format("{} is a file, not a result folder", folder.string()));
  if (fs::is_empty(folder) || is_unfinished(folder)) return;
  throw InputError(
      fmt::format("{} holds other files and is no result folder; name an empty or a new one", folder.string()));
}

void make_folders(fs::path const& folder, std::size_t cells) {
  fs::create_directories(folder / units_name);
  for (std::size_t cell = 0; cell < cells; ++cell) fs::create_directory(folder / cell_path(cell));
  sync_folder(folder / units_name);
  if (::access(folder.c_str(), W_OK) != 0) throw InputError(folder.string() + " cannot be written");
}

/// Who computes here now, unless it is said already; the date alone makes no difference.
void note_provenance(fs::path const& folder, Provenance provenance) {
  auto const file = folder / provenance_name;
  auto const known = fs::exists(file) ? read_whole(file) : "";
  auto const now = to_text(provenance);
  std::erase_if(provenance.entries, [](auto const& entry) { return entry.first == "date"; });
  if (known.find(to_text(provenance)) == std::string::npos)
    write_whole(file, known + (known.empty() ? "" : "\n") + now);
}

}  // namespace

fs::path cell_path(std::size_t cell) { return fs::path(units_name) / fmt::format("cell-{:03}", cell); }

fs::path unit_path(std::size_t cell, std::int64_t first_member) {
  return cell_path(cell) / fmt::format("members-{:06}.h5", first_member);
}

void create_result_folder(fs::path const& folder, std::string const& study_hash, std::string const& canonical_text,
                          std::string const& study_toml, Provenance const& provenance,
                          std::vector<CellLabels> const& cells) {
  if (folder.empty()) throw InputError("the result folder has no name");
  try {
    if (auto const difference = difference_to(folder, study_hash, canonical_text)) throw InputError(*difference);
    bool const begun = has_plan(folder);
    if (!begun) refuse_foreign(folder);
    make_folders(folder, cells.size());
    remove_leftovers(folder);
    note_provenance(folder, provenance);
    if (begun) return;
    write_whole(folder / study_name, study_toml);
    write_whole(folder / plan_name, to_text(FolderPlan{study_hash, canonical_text, cells}));
  } catch (fs::filesystem_error const& error) {
    throw InputError(fmt::format("cannot use {} as result folder: {}", folder.string(), error.code().message()));
  }
}

FolderPlan read_plan(fs::path const& folder) {
  auto const file = folder / plan_name;
  if (!has_plan(folder)) throw InputError(folder.string() + " is no result folder: it has no " + plan_name);
  try {
    return plan_of_text(read_whole(file));
  } catch (std::invalid_argument const& complaint) {
    throw RunError(fmt::format("{} is damaged: {}", file.string(), complaint.what()));
  }
}

std::optional<std::string> difference_to(fs::path const& folder, std::string const& study_hash,
                                         std::string const& canonical_text) {
  if (!has_plan(folder)) return std::nullopt;
  auto const there = read_plan(folder);
  if (there.study_hash == study_hash) return std::nullopt;
  return fmt::format("{} holds the results of another study: {}", folder.string(),
                     differences(there.canonical_text, canonical_text));
}

}  // namespace brouwer
