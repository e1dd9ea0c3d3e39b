# cmake -DFOLDER=... -DOUTPUT=... -P embed_files.cmake writes the files of the page as C++ text, one raw literal each.
set(type_html "text/html")
set(type_js "text/javascript")
set(type_css "text/css")
set(entries "")
foreach(name index.html watch.js map.js watch.css)
  file(READ ${FOLDER}/${name} text)
  string(REGEX REPLACE ".*\\." "" ending ${name})
  set(media_type "${type_${ending}}; charset=utf-8")
  set(path "/${name}")
  if(name STREQUAL "index.html")
    set(path "/")
  endif()
  string(APPEND entries "    {\"${path}\", \"${media_type}\", R\"LOOKOUT(${text})LOOKOUT\"},\n")
endforeach()
file(WRITE ${OUTPUT} "#include \"tools/watch/page.hpp\"

namespace lookout::tools {
namespace {

constexpr PageFile kFiles[] = {
${entries}};

}  // namespace

std::span<const PageFile> page_files() {
  return kFiles;
}

}  // namespace lookout::tools
")
