// SPDX-License-Identifier: MIT
#include "cli/command.h"
#include <filesystem>
#include <httplib.h>
#include <iostream>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "croquis/base/error.h"
#include "croquis/base/text.h"

namespace croquis::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kHost = "127.0.0.1";

struct StudioArguments {
  int port = 8431;
  std::string page;
};

bool is_page(const fs::path& folder) {
  std::error_code ignored;
  return fs::is_regular_file(folder / "index.html", ignored);
}

/// The built page: the folder asked for, or where it lies beside the program, in a build or installed.
fs::path find_page(const std::string& asked) {
  if (!asked.empty()) {
    if (is_page(asked)) return asked;
    throw Error(ErrorCode::io, "there is no built studio in '" + printable(asked) + "': it has no index.html");
  }
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored).parent_path();
  for (const fs::path& folder : {program / "../studio", program / "../share/croquis/studio"}) {
    if (is_page(folder)) return fs::weakly_canonical(folder, ignored);
  }
  throw Error(ErrorCode::io, "the studio is not built: run 'make studio' once, or name its folder with --page");
}

void run_studio(const StudioArguments& options) {
  const fs::path page = find_page(options.page);
  httplib::Server server;
  // Whatever leaves the page's folder is refused by the mount point itself.
  server.set_mount_point("/", page.string());
  server.set_file_extension_and_mimetype_mapping("webmanifest", "application/manifest+json");
  server.set_file_extension_and_mimetype_mapping("wasm", "application/wasm");
  server.set_default_headers({{"Cache-Control", "no-cache"}, {"X-Content-Type-StudioArguments", "nosniff"}});
  // The library's own choice would share a port that is taken.
  server.set_socket_options([](socket_t socket) {
    const int yes = 1;
    setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  });
  const int port = options.port == 0 ? server.bind_to_any_port(kHost)
                                     : (server.bind_to_port(kHost, options.port) ? options.port : -1);
  if (port < 0) {
    throw Error(ErrorCode::io, "port " + std::to_string(options.port) +
                                   " cannot be opened, something else may use it: choose another with --port, or 0 "
                                   "for any that is free");
  }
  std::cout << "The studio is at http://" << kHost << ':' << port << "/ (Ctrl+C ends it)" << std::endl;
  if (!server.listen_after_bind()) throw Error(ErrorCode::io, "the connection was closed by the system");
}

}  // namespace

Command add_studio_command(CLI::App& program) {
  const auto options = std::make_shared<StudioArguments>();
  CLI::App* command = program.add_subcommand("studio", "Serves the drawing table to a browser on this machine");
  command->add_option("--port", options->port, "The port on 127.0.0.1; 0 takes any that is free")
      ->check(CLI::Range(0, 65535))
      ->type_name("N");
  command->add_option("--page", options->page, "The folder of the built page")
      ->type_name("FOLDER")
      ->default_str("beside the program");
  command->footer("Example:\n  croquis studio --port 8431");
  return {command, [options] { run_studio(*options); }};
}

}  // namespace croquis::cli
