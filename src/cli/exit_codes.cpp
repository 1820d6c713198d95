#include "cli/exit_codes.hpp"

namespace carom::cli {

int exit_code(Status status)
{
    switch (status) {
        case Status::reached_end:
            return exit_ok;
        case Status::event_limit:
        case Status::time_limit:
        case Status::zeno:
            return exit_limit;
        case Status::unresolved:
            return exit_failed;
        case Status::interrupted:
            return exit_interrupted;
    }
    return exit_failed;
}

}  // namespace carom::cli
