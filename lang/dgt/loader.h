// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dgt {

/// A source as it comes from outside: its name as the user should see it, its bytes.
struct SourceText {
  std::string name;
  std::string bytes;
};

/// Where a program's macros and definition files come from. The language touches no disk itself.
class SourceLoader {
 public:
  virtual ~SourceLoader() = default;
  /// The macro called `name`, without extension; nothing when there is none.
  [[nodiscard]] virtual std::optional<SourceText> load_macro(std::string_view name) = 0;
  /// The definition file called `name`, without extension; nothing when there is none.
  [[nodiscard]] virtual std::optional<SourceText> load_definitions(std::string_view name) = 0;
  /// False for a program that was never saved: there is nothing beside it.
  [[nodiscard]] virtual bool has_folder() const = 0;
};

/// Loads from folders on disk. Macros: the program's folder, its subfolder `mac`, then `folders`;
/// in each of them `name.mac`, then `name.bgt`. Definition files: `name.bgt` in the program's
/// folder. Upper and lower case are one, a name written exactly so goes first. Names with a folder
/// in them are not found.
class FolderLoader : public SourceLoader {
 public:
  /// `program_folder`: nothing for a program that was never saved.
  explicit FolderLoader(std::optional<std::filesystem::path> program_folder,
                        std::vector<std::filesystem::path> folders = {})
      : program_folder_(std::move(program_folder)), folders_(std::move(folders)) {}

  [[nodiscard]] std::optional<SourceText> load_macro(std::string_view name) override;
  [[nodiscard]] std::optional<SourceText> load_definitions(std::string_view name) override;
  [[nodiscard]] bool has_folder() const override { return program_folder_.has_value(); }

 private:
  std::optional<std::filesystem::path> program_folder_;
  std::vector<std::filesystem::path> folders_;
};

}  // namespace dgt
