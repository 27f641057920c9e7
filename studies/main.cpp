#include "studies/program.hpp"

int main(int argc, char** argv) { return brouwer::program(argc, argv, brouwer::builtin_catalogue()); }
