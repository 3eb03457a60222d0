// SPDX-License-Identifier: BSL-1.0
#include "solar_system.hpp"

#include <sstream>

#include "hilger/error.hpp"
#include "hilger/scalar.hpp"

namespace program {

solar_system read_solar_system(std::istream& in, std::string const& source) {
    namespace error = hilger::error;
    solar_system s;
    std::string line;
    int number = 0;
    bool header = false;
    while (std::getline(in, line)) {
        ++number;
        if (line.empty() or line.front() == '#') continue;
        if (not header) {
            header = true;
            if (line != "body,mass,x,y,z,vx,vy,vz")
                error::raise<error::unreadable>("line ", number, " of ", source, " should be the header body,mass,x,y,z,vx,vy,vz and is '",
                                                line, "'");
            continue;
        }
        int const body = static_cast<int>(s.names.size());
        if (body == bodies) error::raise<error::unreadable>(source, " has more than ", bodies, " bodies");
        std::istringstream fields(line);
        std::string name;
        std::getline(fields, name, ',');
        double value[7];
        for (int k = 0; k < 7; ++k) {
            std::string field;
            std::getline(fields, field, ',');
            std::istringstream word(field);
            if (not(word >> value[k]) or not word.eof() or not hilger::is_finite(value[k]))
                error::raise<error::unreadable>("line ", number, " of ", source, " should be a name and 7 numbers, and its field ", k + 2,
                                                " is '", field, "'");
        }
        if (not(value[0] > 0))
            error::raise<error::unreadable>("line ", number, " of ", source, ": a mass is positive, and this one is ", value[0]);
        s.names.push_back(name);
        for (int c = 0; c < 3; ++c) {
            s.mass(3 * body + c) = value[0];
            s.q(3 * body + c) = value[1 + c];
            s.v(3 * body + c) = value[4 + c];
        }
    }
    if (static_cast<int>(s.names.size()) != bodies)
        error::raise<error::unreadable>(source, " has ", s.names.size(), " bodies, and the outer solar system has ", bodies);

    // To the frame of the centre of mass, which removes the drift.
    Eigen::Vector3d centre = Eigen::Vector3d::Zero(), drift = Eigen::Vector3d::Zero();
    double total = 0;
    for (int i = 0; i < bodies; ++i) {
        double const m = s.mass(3 * i);
        centre += m * s.q.segment<3>(3 * i);
        drift += m * s.v.segment<3>(3 * i);
        total += m;
    }
    for (int i = 0; i < bodies; ++i) {
        s.q.segment<3>(3 * i) -= centre / total;
        s.v.segment<3>(3 * i) -= drift / total;
    }
    return s;
}

} // namespace program
