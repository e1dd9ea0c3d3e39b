// A sonar's driver: its target list as messages. Built against LCM and our types alone, which are headers.
#include <chrono>
#include <lcm/lcm-cpp.hpp>
#include <thread>

#include <lookout/sonar_scan_t.hpp>
#include <lookout/vehicle_state_t.hpp>

int main() {
  lcm::LCM link;  // At LCM_DEFAULT_URL, else LCM's own address.
  if (!link.good()) return 1;
  for (int ping = 0; ping < 40; ++ping) {
    lookout::vehicle_state_t state{};  // Braces: without them fields hold anything.
    state.utime = std::chrono::duration_cast<std::chrono::microseconds>(
                      std::chrono::system_clock::now().time_since_epoch())
                      .count();
    state.north = 0.1 * ping;  // Metres; heading in radians clockwise from north.
    link.publish("VEHICLE_STATE", &state);

    lookout::sonar_scan_t scan{};
    scan.utime = state.utime;         // When the ping was sent; the pose at that very time serves it.
    scan.sequence = ping;             // One more each ping: gaps are counted as losses.
    scan.first_bearing = -0.7766715;  // Radians, positive to starboard, of the centre of beam 0.
    scan.bearing_step = 0.0174533;
    scan.num_beams = 90;
    scan.max_range = 150.0;
    scan.bearing = {0.1, -0.5};  // What the sonar reported: one entry an echo.
    scan.range = {40.0, 90.0};
    scan.intensity = {1.0, 1.0};
    scan.num_returns = 2;  // Must be the size of all three.
    link.publish("SONAR_SCAN", &scan);
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
}
