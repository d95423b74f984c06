// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/driver/batch.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <filesystem>
#include <map>
#include <mutex>
#include <thread>

#include "apps/driver/nc_files.h"
#include "apps/driver/write_messages.h"
#include "kernel/thread_arithmetic.h"
#include "post/write.h"

namespace dgt {
namespace {

namespace fs = std::filesystem;

/// `*` any run, `?` any one character.
bool fits(std::string_view name, std::string_view pattern) {
  std::size_t star = std::string_view::npos;
  std::size_t resumed = 0;
  std::size_t n = 0;
  std::size_t p = 0;
  while (n < name.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      resumed = n;
    } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == name[n])) {
      ++p;
      ++n;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      n = ++resumed;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

/// By their inputs: where each goes, under the folder.
using Found = std::map<std::string, fs::path>;

void add_folder(const fs::path& folder, Found& found) {
  constexpr auto kPassing = fs::directory_options::skip_permission_denied;
  for (const auto& entry : fs::recursive_directory_iterator(folder, kPassing)) {
    const fs::path& file = entry.path();
    if (entry.is_regular_file() && language_of(file))
      found.try_emplace(file, file.lexically_relative(folder));
  }
}

/// False when no name fits.
bool add_pattern(const fs::path& pattern, Found& found) {
  const fs::path folder = pattern.has_parent_path() ? pattern.parent_path() : ".";
  std::error_code no_folder;
  bool any = false;
  for (const auto& entry : fs::directory_iterator(folder, no_folder)) {
    const fs::path name = entry.path().filename();
    if (!entry.is_regular_file() || !fits(name.string(), pattern.filename().string())) continue;
    any = true;
    found.try_emplace(pattern.has_parent_path() ? entry.path() : name, name);
  }
  return any;
}

BatchResult work(const BatchItem& item, const Settings& settings) {
  BatchResult result;
  result.item = item;
  auto made = compile_file(item.input, settings.source);
  if (!made) {
    result.failure = made.error();
    return result;
  }
  result.sources = made->result.files;
  result.sources.push_back(made->file);
  result.bag = std::move(made->bag);
  if (result.bag.has_errors()) return result;
  const WriteResult written = write(*made->result.path, settings.dialect);
  const DiagnosticBag said = explain(written, settings.dialect, *made);
  for (const Diagnostic& diagnostic : said.all()) result.bag.add(diagnostic);
  if (!written.faults.empty()) return result;
  std::error_code no_folder;
  fs::create_directories(fs::path(item.output).parent_path(), no_folder);
  if (const auto stored = write_file(item.output, written.text); !stored) {
    result.failure = stored.error();
    return result;
  }
  result.blocks = written.report.blocks;
  result.deviation = written.report.deviation;
  result.is_done = true;
  return result;
}

}  // namespace

tl::expected<std::vector<BatchItem>, BatchFault> plan_batch(const std::vector<std::string>& inputs,
                                                            const std::string& folder,
                                                            const Dialect& dialect) {
  Found found;
  for (const std::string& input : inputs) {
    if (fs::is_directory(input)) {
      add_folder(input, found);
    } else if (fs::exists(input)) {
      found.try_emplace(input, fs::path(input).filename());
    } else if (!add_pattern(input, found)) {
      return tl::unexpected(BatchFault{input, {}, {}});
    }
  }
  std::vector<BatchItem> items;
  std::map<fs::path, std::string> taken;
  for (const auto& [input, place] : found) {
    fs::path output = fs::path(folder) / place;
    output.replace_extension(extension_of(dialect));
    const auto [other, is_new] = taken.try_emplace(output, input);
    if (!is_new) {
      return tl::unexpected(BatchFault{other->second, input, output});
    }
    items.push_back({input, output});
  }
  return items;
}

std::vector<BatchResult> run_batch(const std::vector<BatchItem>& items, const Settings& settings,
                                   unsigned jobs) {
  std::vector<BatchResult> results(items.size());
  std::atomic<std::size_t> next = 0;
  std::exception_ptr broken;
  std::mutex lock;
  const auto serve = [&] {
    for (std::size_t i = next++; i < items.size(); i = next++) {
      try {
        results[i] = work(items[i], settings);
      } catch (...) {  // our own mistake: told once, when all have stopped
        const std::scoped_lock hold(lock);
        if (!broken) broken = std::current_exception();
        next = items.size();
      }
    }
  };
  {
    std::vector<std::jthread> threads;
    const std::size_t most = std::min<std::size_t>(jobs, items.size());
    for (std::size_t i = 1; i < most; ++i) {
      threads.emplace_back([&] {
        serve();
        release_thread_arithmetic();
      });
    }
    serve();
  }
  if (broken) std::rethrow_exception(broken);
  return results;
}

std::string table_of(const std::vector<BatchResult>& results) {
  std::string table;
  for (const BatchResult& result : results) {
    if (result.is_done) {
      table += fmt::format("done   {:7} blocks {:>8} mm  {} -> {}\n", result.blocks,
                           told(result.deviation), result.item.input, result.item.output);
    } else {
      table += fmt::format("failed {:29}{}\n", "", result.item.input);
    }
  }
  return table;
}

}  // namespace dgt
