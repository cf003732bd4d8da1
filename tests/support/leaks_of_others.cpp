// What the leak sanitizer passes by. OpenImageIO loses the message of a PNG that breaks off, since libpng leaves its
// frames by longjmp, and keeps its last message for ever.
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libOpenImageIO";
}
