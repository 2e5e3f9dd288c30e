// orbicube view: any files that can be read, to look at in a browser or as a picture.
#include <unistd.h>

#include <charconv>
#include <deque>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/counted.h"
#include "files/surface_file.h"
#include "mesh/files/file.h"
#include "mesh/files/text_scanner.h"
#include "scenes/view_page.h"
#include "session/program.h"
#include "session/unused_options.h"
#include "verbs/verbs.h"
#include "view_page/viewed_file.h"

namespace orbicube::cli {
namespace {

struct ViewOptions {
  std::vector<std::string> files;
  std::string output;
  std::string png;
  std::string size = "1280x800";
  std::string title;
  std::string up = "y";
  std::string preset;
  bool weld = false;
};

// A folder that only the user may enter, with the page in it; removed at the end unless it is kept.
class PageFolder {
 public:
  PageFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "orbicube-view-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw Failure(Exit::no_result, name, "io", "cannot make a temporary folder");
    path_ = name;
  }
  PageFolder(const PageFolder&) = delete;
  PageFolder& operator=(const PageFolder&) = delete;
  ~PageFolder() {
    std::error_code ignored;
    if (!kept_) std::filesystem::remove_all(path_, ignored);
  }

  const std::filesystem::path& path() const { return path_; }
  void keep() { kept_ = true; }

 private:
  std::filesystem::path path_;
  bool kept_ = false;
};

void write_text(const std::filesystem::path& path, const std::string& text) {
  about(path, Role::output, [&] {
    mesh::OutputFile file(path);
    file.write(text);
    file.commit();
  });
}

// WIDTHxHEIGHT as Chromium takes it, WIDTH,HEIGHT.
std::string window_size(const std::string& text) {
  constexpr int least = 100, most = 8000;
  const std::size_t middle = text.find('x');
  const auto number = [&](std::size_t begin, std::size_t end) {
    int value = 0;
    const auto [stop, problem] = std::from_chars(text.data() + begin, text.data() + end, value);
    return problem == std::errc() && stop == text.data() + end && value >= least && value <= most ? value : 0;
  };
  const int width = middle == std::string::npos ? 0 : number(0, middle);
  const int height = width == 0 ? 0 : number(middle + 1, text.size());
  if (height == 0)
    throw Failure(Exit::wrong_input, "", "usage",
                  "--size is WIDTHxHEIGHT, each from 100 to 8000 pixels, not " + mesh::in_quotes(text));
  return std::to_string(width) + "," + std::to_string(height);
}

// The address of a file by its absolute path; bytes with a meaning in addresses are written as %XX (RFC 3986).
std::string address_of(const std::filesystem::path& path) {
  constexpr std::string_view as_they_are = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-._~/";
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string result = "file://";
  for (const char c : path.string()) {
    const auto byte = static_cast<unsigned char>(c);
    if (as_they_are.find(c) != std::string_view::npos)
      result += c;
    else
      result.append({'%', digits[byte / 16], digits[byte % 16]});
  }
  return result;
}

// A picture of the page by a browser without a screen.
void draw(const std::string& page, const std::string& size, const std::filesystem::path& png, Session& session) {
  const auto browser = find_browser();
  if (!browser)
    throw Failure(
        Exit::no_result, png.string(), "unsupported",
        "pictures are drawn by Chromium, and there is no chromium, chromium-browser or google-chrome in PATH; "
        "install one, or write the page with -o and open it in a browser");
  const PageFolder folder;
  const std::filesystem::path html = std::filesystem::absolute(folder.path() / "page.html"),
                              picture = folder.path() / "picture.png";
  write_text(html, page);
  std::vector<std::string> arguments = {"--headless=new",
                                        "--disable-gpu-sandbox",
                                        "--disable-dev-shm-usage",
                                        "--disable-extensions",
                                        "--no-first-run",
                                        "--use-angle=swiftshader",
                                        "--enable-unsafe-swiftshader",
                                        "--hide-scrollbars",
                                        "--force-device-scale-factor=1",
                                        "--virtual-time-budget=60000",
                                        "--user-data-dir=" + (folder.path() / "profile").string(),
                                        "--window-size=" + size,
                                        "--screenshot=" + picture.string(),
                                        address_of(html)};
  // Chromium's sandbox does not work for the superuser. The page loads nothing but itself.
  if (geteuid() == 0) arguments.insert(arguments.begin(), "--no-sandbox");
  const int code =
      about(png, Role::output, [&] { return run_program(*browser, arguments, "drawing", session.host()); });
  std::error_code problem;
  if (!std::filesystem::exists(picture, problem))
    throw Failure(Exit::no_result, png.string(), "io",
                  browser->string() + " drew no picture and ended with code " + std::to_string(code));
  const auto bytes = about(png, Role::output, [&] { return mesh::read_file(picture, session.host()); });
  write_text(session.stage(png), std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

void open_in_browser(const std::string& page, Session& session) {
  const auto opener = find_opener();
  if (!opener)
    throw Failure(Exit::no_result, "", "unsupported",
                  "there is no xdg-open in PATH to open a browser; write the page with -o FILE.html or a picture with "
                  "--png FILE.png");
  PageFolder folder;
  const std::filesystem::path html = folder.path() / "view.html";
  write_text(html, page);
  about(html, Role::output, [&] { start_program(*opener, {html.string()}); });
  folder.keep();  // the browser reads it later
  session.figures()["opened"] = html.string();
  session.say("opened " + html.string());
}

// Each file with a mesh, and what follows it: a frame field.
void read_files(const ViewOptions& options, Session& session, std::deque<ViewedFile>& files) {
  for (std::size_t i = 0; i < options.files.size(); ++i) {
    const std::filesystem::path path = options.files[i];
    const base::Stage stage(session.host(), 0.8 / static_cast<double>(options.files.size() - i));
    if (is_frames(path)) {
      if (files.empty())
        throw Failure(Exit::wrong_input, path.string(), "usage",
                      "a frame field without its mesh: give the mesh of tetrahedra before it");
      add_field(path, session, files.back());
    } else {
      read_viewed(path, options.weld, session, files.emplace_back());
    }
  }
}

void view(const ViewOptions& options, Session& session) {
  session.options() = {{"files", options.files},
                       {"output", options.output},
                       {"png", options.png},
                       {"up", options.up},
                       {"weld", options.weld}};
  const std::string size = window_size(options.size);
  for (const std::string& output : {options.output, options.png})
    if (!output.empty()) require_folder(output);
  std::deque<ViewedFile> files;
  read_files(options, session, files);
  std::vector<ViewItem> items;
  std::string title = options.title;
  for (const ViewedFile& file : files) {
    items.push_back(file.item);
    if (options.title.empty()) title += (title.empty() ? "" : " – ") + file.item.name;
  }
  const auto page = [&](const std::string& preset) {
    return about(options.files.front(), Role::input,
                 [&] { return view_page(items, title, {.z_up = options.up == "z", .preset = preset}); });
  };
  session.figures() = {{"views", items.size()}};
  if (!options.output.empty()) {
    const std::string text = page(options.preset);
    write_text(session.stage(options.output), text);
    session.figures().update({{"output", options.output}, {"bytes", text.size()}});
    session.say("wrote " + options.output + ": " + base::counted(items.size(), "view") + ", open it in a browser");
  }
  if (!options.png.empty()) {
    draw(page("picture&" + options.preset), size, options.png, session);
    session.figures()["png"] = options.png;
    session.say("drew " + options.png);
  }
  if (options.output.empty() && options.png.empty()) open_in_browser(page(options.preset), session);
  for (const std::string& note : session.notes())
    session.say("  note: " + note);
}

}  // namespace

void add_view(CLI::App& app, CommonOptions& common) {
  CLI::App* verb = app.add_subcommand("view", "show meshes, maps and frame fields in a browser or as a picture");
  const auto options = std::make_shared<ViewOptions>();
  verb->add_option(
          "FILES", options->files,
          std::string("meshes to show: ") + surface_endings + "; a frame field, .frames, follows its tetrahedra")
      ->required()
      ->type_name("FILE...");
  verb->add_option("-o,--output", options->output, "page to write; without it and --png the page opens in a browser")
      ->type_name("FILE.html");
  verb->add_option("--png", options->png, "picture to draw, by headless Chromium")->type_name("FILE.png");
  verb->add_option("--size", options->size, "size of the picture in pixels [default: " + options->size + "]")
      ->type_name("WIDTHxHEIGHT");
  verb->add_option("--title", options->title, "heading of the page [default: the names of the files]")
      ->type_name("TEXT");
  verb->add_option("--up", options->up, "vertical axis, y or z [default: y]")
      ->check(CLI::IsMember({"y", "z"}))
      ->type_name("AXIS");
  verb->add_option("--preset", options->preset,
                   "initial settings of the page, such as color=jacobian&slice=0,0.5&quality=0.6&theme=dark")
      ->type_name("TEXT");
  add_weld_option(*verb, options->weld);
  add_common_options(*verb, common);
  verb->footer(
      "Several files have linked views beside each other. The page is one file that loads nothing else and needs no "
      "network.");
  verb->callback([options, verb, &common] {
    Session session(common, "view", options->files.front());
    session.run([&] {
      refuse_unused_view_options(*verb);
      view(*options, session);
    });
  });
}

}  // namespace orbicube::cli
