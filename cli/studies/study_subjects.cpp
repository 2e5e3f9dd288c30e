#include "studies/study_subjects.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <iterator>
#include <mutex>
#include <optional>
#include <string_view>
#include <utility>

#include "base/counted.h"
#include "mesh/search/measures.h"
#include "report/sphere_uses.h"
#include "report/unit_size.h"
#include "studies/kept_subject.h"
#include "studies/rounding.h"
#include "studies/subject_file.h"

namespace orbicube::cli {
namespace {

// Written into the hash of each subject: raise it when results of the same input change.
constexpr const char* version_of_results = "3";

std::string key_of(const correspondence::SubjectOptions& options) {
  return std::string(version_of_results) + " " + std::to_string(static_cast<int>(options.grid)) + ":" +
         std::to_string(options.resolution) + " " + (options.align ? "" : "not ") + "aligned" +
         (options.joint ? " jointly" : "") + " " + std::to_string(options.seed) + " ";
}

Json json_from(const harmonics::Coefficients& functions) {
  return {{"degree", functions.degree}, {"channels", functions.channels}, {"values", functions.values}};
}

// Throws Error "parse" for other functions than those that were written.
harmonics::Coefficients coefficients_from(const Json& json) {
  harmonics::Coefficients functions(json.at("degree").get<std::uint32_t>(), json.at("channels").get<std::size_t>(),
                                    std::pmr::get_default_resource());
  const auto values = json.at("values").get<std::vector<double>>();
  if (values.size() != functions.values.size()) throw base::Error("parse", "the first subject has other functions");
  std::copy(values.begin(), values.end(), functions.values.begin());
  return functions;
}

// The number of subjects that are mapped where the first one can be.
std::size_t count_of(const SubjectWork& work, std::size_t listed) {
  if (work.which == Mapped::first) return 1;
  if (work.which != Mapped::some) return listed;
  return work.some.size() + (work.some.empty() || work.some.front() > 0 ? 1 : 0);
}

// How far all subjects together are, which threads report.
class SharedProgress {
 public:
  SharedProgress(const base::Host& host, std::size_t listed, std::size_t mapped)
      : host_(host), fractions_(listed, 0.0), mapped_(mapped) {}

  // Returns false if the work is to stop.
  bool update(std::size_t i, double fraction) {
    const std::scoped_lock lock(mutex_);
    sum_ += std::max(0.0, fraction - fractions_[i]);
    fractions_[i] = std::max(fractions_[i], fraction);
    constexpr double steps = 1000;
    const auto total = static_cast<std::uint64_t>(steps) * mapped_;
    try {
      host_.report("mapping the subjects", std::min(total, static_cast<std::uint64_t>(steps * sum_)), total);
    } catch (const base::Error&) {
      cancelled_ = true;
    }
    return !cancelled_;
  }
  void cancel() { cancelled_ = true; }
  void require_not_cancelled() const {
    if (cancelled_) throw base::Error("cancelled", "stopped while subjects were mapped");
  }

 private:
  const base::Host& host_;
  std::mutex mutex_;
  std::vector<double> fractions_;
  const std::size_t mapped_;
  double sum_ = 0;
  std::atomic<bool> cancelled_ = false;
};

// About a subject that is not for this process to map again.
class MappedElsewhere : public Failure {
  using Failure::Failure;
};

class SubjectMaker {
 public:
  SubjectMaker(const std::vector<StudySubject>& list, const SubjectWork& work, const std::filesystem::path& folder,
               const correspondence::SubjectOptions& options, std::int32_t label, const CommonOptions& common,
               Session& session)
      : list_(list),
        work_(work),
        folder_(folder),
        options_(options),
        label_(label),
        common_(common),
        session_(session),
        progress_(session.host(), list.size(), count_of(work, list.size())),
        grid_(sphere_map::make_grid(options.grid, options.resolution, session.host())),
        key_(key_of(options)),
        hashes_(list.size()),
        mapped_(list.size()),
        failed_(list.size()) {}

  StudySubjects run() {
    std::size_t first = 0;
    // The first one uses all threads; the others one each.
    while (first < list_.size() && !make(first, session_.host().thread_count))
      require_same_first(first++);
    if (first < list_.size() && work_.which != Mapped::first) {
      first_made_ = true;
      key_ += hash_of(mapped_[first]->positions);
      if (options_.align) functions_.emplace(coefficients_from(mapped_[first]->functions));
      const std::vector<std::size_t> others = others_than(first);
      const unsigned threads = others.size() == 1 ? session_.host().thread_count : 1;
      session_.host().parallel_for(others.size(), [&](std::size_t i) { make(others[i], threads); });
    }
    progress_.require_not_cancelled();
    if (const std::size_t count = made_elsewhere_; count > 0) {
      session_.note(base::counted(count, "subject") + " of the study before " + (count == 1 ? "was" : "were") +
                    " mapped on a machine whose elementary functions round otherwise, and again on this one");
    }
    return collected();
  }

 private:
  // Returns whether the subject was mapped. Throws Error "cancelled".
  bool make(std::size_t i, unsigned threads) {
    progress_.require_not_cancelled();
    try {
      mapped_[i] = made(i, threads);
      mapped_[i]->number = i;
    } catch (const MappedElsewhere&) {
      throw;
    } catch (const Failure& failure) {
      fail(i, failure.kind(), failure.what());
    } catch (const base::Error& error) {
      fail(i, error.kind(), error.what());
    } catch (const std::bad_alloc&) {
      fail(i, "out-of-memory", "there is not enough memory");
    }
    progress_.update(i, 1);
    progress_.require_not_cancelled();
    return mapped_[i].has_value();
  }

  // A subject that another process might have memory for may not be passed over by this one alone.
  void require_same_first(std::size_t failed) const {
    if (work_.which != Mapped::all && failed_[failed]->kind == "out-of-memory") throw out_of_memory(list_[failed].file);
  }

  // What is to be mapped besides it. Those before it have been tried.
  std::vector<std::size_t> others_than(std::size_t first) const {
    std::vector<std::size_t> others;
    if (work_.which == Mapped::some) {
      std::copy_if(work_.some.begin(), work_.some.end(), std::back_inserter(others),
                   [&](std::size_t i) { return i > first; });
    } else {
      for (std::size_t i = first + 1; i < list_.size(); ++i)
        others.push_back(i);
    }
    return others;
  }

  void fail(std::size_t i, const std::string& kind, const std::string& text) {
    if (kind == "cancelled" || kind == "time-limit") progress_.cancel();
    if (failed_[i]) return;  // a study before has found it
    failed_[i] = FailedSubject{i, kind, text};
    if (work_.which != Mapped::kept && !hashes_[i].empty() && fails_again(kind))
      keep_failure(folder_, list_[i].name, hashes_[i], *failed_[i]);
  }

  MappedSubject made(std::size_t i, unsigned threads) {
    const StudySubject& subject = list_[i];
    const std::string file = subject.file.string();
    CommonOptions own = common_;
    own.quiet = true;
    own.threads = threads;
    own.report.clear();
    if (own.time_limit > 0) own.time_limit = std::max(1e-3, own.time_limit - session_.seconds());
    Session reading(own, "study", file);
    const std::string hash = hash_of_input(file, is_label_image(file) ? key_ + std::to_string(label_) : key_, reading);
    if (is_of_this_machine(i, hash, reading.host())) {
      if (std::optional<MappedSubject> kept = kept_subject(folder_, subject.name, hash, reading.host())) {
        if (kept->positions.size() == grid_.directions.size()) return std::move(*kept);
      }
      if ((failed_[i] = kept_failure(folder_, subject.name, hash, reading.host()))) {
        failed_[i]->number = i;
        throw Failure(Exit::no_result, file, failed_[i]->kind, failed_[i]->text);
      }
    }
    if (work_.which == Mapped::kept) {
      throw Failure(Exit::no_result, file, "no-valid-result",
                    "it has no result for these options yet; give --stage subjects --subjects " + subject.name);
    }
    hashes_[i] = hash;
    const double start = session_.seconds();
    const ClosedSurface surface = read_subject(subject.file, label_, reading);
    require_ordinary_size(surface.mesh, file);
    base::Host host;
    host.memory = session_.host().memory;
    host.thread_count = threads;
    host.on_progress = [&](const base::Progress& p) { return progress_.update(i, 0.99 * p.fraction); };
    correspondence::Subject result =
        correspondence::map_subject(surface.mesh, functions_ ? &*functions_ : nullptr, options_, host);
    MappedSubject mapped{i, std::move(result.positions), figures_of(result, surface, reading)};
    if (result.functions) mapped.functions = json_from(*result.functions);
    mapped.figures["notes"] = reading.notes();
    mesh::Mesh on_grid(host.memory);
    on_grid.positions = mapped.positions;
    on_grid.triangles = grid_.triangles;
    mapped.figures["max_distance_percent"] =
        100 * json_of_distance(surface.mesh, on_grid, host)["from_surface"]["max_of_diagonal"].get<double>();
    keep_subject(folder_, subject.name, hash, mapped, grid_.triangles, reading);
    mapped.seconds = session_.seconds() - start;
    return mapped;
  }

  // Whether what the folder has of a subject, if anything, was made on a machine that rounds as this one.
  bool is_of_this_machine(std::size_t i, const std::string& hash, const base::Host& host) {
    const std::optional<std::string> digest = kept_rounding(folder_, list_[i].name, hash, host);
    if (!digest || *digest == rounding_digest()) return true;
    const bool group = work_.which == Mapped::kept;
    if (group || (work_.which == Mapped::some && !first_made_)) {
      throw MappedElsewhere(Exit::no_result, list_[i].file.string(), "unsupported",
                            "it was mapped on a machine whose elementary functions round otherwise (digest " + *digest +
                                ", here " + rounding_digest() +
                                "), and a study takes subjects of machines that round alike, with one C library and "
                                "processors of one kind; --stage " +
                                (group ? "subjects" : "first") + " on this machine maps it again");
    }
    ++made_elsewhere_;
    return false;
  }

  static Json figures_of(const correspondence::Subject& result, const ClosedSurface& surface, const Session& reading) {
    const mesh::Measures measures = mesh::measures(surface.mesh.positions, surface.mesh.triangles, reading.host());
    return {{"vertices", surface.mesh.positions.size()},
            {"triangles", surface.mesh.triangles.size()},
            {"area", measures.area},
            {"volume", measures.volume},
            {"correlation", result.correlation},
            {"turn", result.turn},
            {"flipped", result.flipped}};
  }

  StudySubjects collected() {
    StudySubjects result;
    for (std::size_t i = 0; i < list_.size(); ++i) {
      if (mapped_[i]) result.mapped.push_back(std::move(*mapped_[i]));
      if (failed_[i]) result.failed.push_back(*failed_[i]);
    }
    return result;
  }

  const std::vector<StudySubject>& list_;
  const SubjectWork& work_;
  const std::filesystem::path& folder_;
  const correspondence::SubjectOptions& options_;
  const std::int32_t label_;
  const CommonOptions& common_;
  Session& session_;
  SharedProgress progress_;
  sphere_map::Grid grid_;
  std::string key_;
  std::optional<harmonics::Coefficients> functions_;  // of the first subject
  bool first_made_ = false;
  std::atomic<std::size_t> made_elsewhere_ = 0;
  std::vector<std::string> hashes_;  // of those that are mapped by this process
  std::vector<std::optional<MappedSubject>> mapped_;
  std::vector<std::optional<FailedSubject>> failed_;
};

}  // namespace

bool fails_again(const std::string& kind) {
  constexpr std::array<std::string_view, 5> passing = {"cancelled", "time-limit", "out-of-memory", "io", "internal"};
  return std::find(passing.begin(), passing.end(), kind) == passing.end();
}

StudySubjects map_subjects(const std::vector<StudySubject>& list, const SubjectWork& work,
                           const std::filesystem::path& folder, const correspondence::SubjectOptions& options,
                           std::int32_t label, const CommonOptions& common, Session& session) {
  StudySubjects result = SubjectMaker(list, work, folder, options, label, common, session).run();
  const bool whole = work.which == Mapped::all || work.which == Mapped::kept;
  if (result.failed.empty() || (whole ? result.mapped.size() >= 2 : result.failed.size() < list.size())) return result;
  const FailedSubject& failed = result.failed.front();
  throw Failure(Exit::no_result, list[failed.number].file.string(), "no-valid-result",
                base::counted(result.failed.size(), "subject", "subjects") + " of " + std::to_string(list.size()) +
                    " cannot be mapped; this one: " + failed.kind + ": " + failed.text);
}

}  // namespace orbicube::cli
