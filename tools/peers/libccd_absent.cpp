#include "tunnel/peers.hpp"

namespace carom::tunnel {

Peers libccd_peers()
{
    return {{"libccd_advancement"}, {}, "built without libccd (install libccd-dev, configure and build again)"};
}

}  // namespace carom::tunnel
