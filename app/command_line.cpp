#include "app/command_line.h"
namespace sturm { int run_command_line(int, char**) { return 2; } }
