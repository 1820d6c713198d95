#include "cli/cli.hpp"

int main(int argc, char** argv)
{
    return carom::cli::run_cli(argc, argv);
}
