#pragma once
/// Every key of a connection file, object by object.

#include "aisle/formats/connections/connection_file.hpp"
#include "object_fields.hpp"

namespace aisle {

ObjectFields fields_of(ConnectedFrames& frames);
ObjectFields fields_of(ConnectedScan& scan);
ObjectFields fields_of(ConnectedCamera& camera);
ObjectFields fields_of(ConnectedOdometry& odometry);
ObjectFields fields_of(ConnectedSwitch& bumper_or_stop);
ObjectFields fields_of(ConnectedBattery& battery);
ObjectFields fields_of(ConnectedJoystick& joystick);
ObjectFields fields_of(ConnectedCommands& commands);
ObjectFields fields_of(ConnectedLimits& limits);
/// All but the list of peers.
ObjectFields fields_of(ConnectedNetwork& network);
/// The single values: vehicle, clock.
ObjectFields fields_of(Connection& connection);

/// The objects and the key of each: visit(key, object).
template <class SomeConnection, class Visit>
void for_each_object(SomeConnection& connection, const Visit& visit) {
  visit("frames", connection.frames);
  visit("scan", connection.scan);
  visit("odometry", connection.odometry);
  visit("battery", connection.battery);
  visit("joystick", connection.joystick);
  visit("command", connection.commands);
  visit("limits", connection.limits);
}

/// The lists of objects and the key of each.
template <class SomeConnection, class Visit>
void for_each_list(SomeConnection& connection, const Visit& visit) {
  visit("cameras", connection.cameras);
  visit("bumpers", connection.bumpers);
  visit("emergency_stops", connection.emergency_stops);
}

}  // namespace aisle
