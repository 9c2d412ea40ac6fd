// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality.h"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <mutex>
#include <optional>
#include <thread>

#include "cloud_list.h"
#include "markdown.h"
#include "measure.h"
#include "method_choice.h"
#include "quality_table.h"
#include "results.h"
#include "scratch_folder.h"

namespace filmsticking::bench {
namespace {

/// The name of a cloud as a folder's.
std::string folder_name(const Row& row) {
  std::string name =
      row.text("shape") + "_" + row.text("kind") + "_" + row.text("points") + "_" + row.text("seed");
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == ' ' || c == '/' || c == ':'; }, '-');
  return name;
}

class QualityRun {
 public:
  QualityRun(const CommandLine& command, const std::string& folder)
      : entries_(find_methods()),
        methods_(choose_methods(command.methods, entries_)),
        plans_(list_clouds(command)),
        results_(command.csv, command.fresh),
        folder_(folder),
        keep_(!command.keep.empty()) {
    measurement_.limits = command.limits;
    measurement_.threads = command.threads;
    measurement_.timing_fit = command.jobs == 1;
    rows_.resize(plans_.size());
  }

  std::vector<Row> run(int jobs) {
    std::vector<std::thread> workers;
    for (int i = 0; i < jobs; ++i) workers.emplace_back([this] { work(); });
    for (std::thread& worker : workers) worker.join();
    if (error_) std::rethrow_exception(error_);
    std::vector<Row> all;
    for (const std::vector<Row>& rows : rows_) all.insert(all.end(), rows.begin(), rows.end());
    return all;
  }

  const std::vector<std::string>& methods() const { return methods_; }

 private:
  void work() {
    for (std::size_t i; (i = next_++) < plans_.size();) {
      try {
        take(i);
      } catch (...) {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (!error_) error_ = std::current_exception();
        next_ = plans_.size();
      }
    }
  }

  /// All methods on one cloud, which is made for the first method without a row.
  void take(std::size_t index) {
    const CloudPlan& plan = plans_[index];
    std::optional<CloudFiles> files;
    std::string folder;
    Row cloud = cloud_row(plan.input, plan.spec);
    const auto prepare = [&] {
      folder = folder_ + "/" + folder_name(cloud);
      files = prepare_cloud(plan.input, plan.spec, false, folder);
      cloud = files->row;
    };
    // Whether a file is a mesh or a cloud is known once it is read; only then are rows of clouds found.
    const bool known = std::all_of(methods_.begin(), methods_.end(), [&](const std::string& method) {
      return results_.has(planned_row(cloud, method, measurement_));
    });
    if (!known) prepare();
    for (const std::string& method : methods_) {
      const Row planned = planned_row(cloud, method, measurement_);
      if (const Row* done = results_.find(planned)) {
        rows_[index].push_back(*done);
        continue;
      }
      const std::string mesh = folder + "/" + method + ".ply";
      const Row row = measure(*files, method, entries_.at(method), mesh, measurement_);
      results_.add(row);
      rows_[index].push_back(row);
      print(row);
    }
    if (!keep_ && files) std::filesystem::remove_all(folder);
  }

  void print(const Row& row) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto show = [&](const char* column) { return rounded(row.number(column), 3); };
    std::fprintf(stderr, "%s, %s, %s points, seed %s: %s: %s%s%s; %s s, Chamfer %s, interpolated %s %%\n",
                 row.text("shape").c_str(), row.text("kind").c_str(), row.text("points").c_str(),
                 row.text("seed").c_str(), row.text("method").c_str(), row.text("status").c_str(),
                 row.text("message").empty() ? "" : ": ", row.text("message").c_str(),
                 show("seconds").c_str(), show("chamfer_e3").c_str(), show("interpolated").c_str());
  }

  const std::map<std::string, MethodEntry> entries_;
  const std::vector<std::string> methods_;
  const std::vector<CloudPlan> plans_;
  Results results_;
  const std::string folder_;
  const bool keep_;
  Measurement measurement_;
  std::atomic<std::size_t> next_{0};
  std::mutex mutex_;
  std::exception_ptr error_;
  std::vector<std::vector<Row>> rows_;  // by cloud
};

}  // namespace

void compare_quality(const CommandLine& command) {
  const ScratchFolder scratch;
  QualityRun run(command, command.keep.empty() ? scratch / "clouds" : command.keep);
  const std::vector<Row> rows = run.run(command.jobs);
  publish(quality_tables(rows, run.methods(), command.peer, command.by_shape), command.markdown);
}

}  // namespace filmsticking::bench
