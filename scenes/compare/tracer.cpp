// A small ray tracer that prints what it does, for `rayscope compare`. C++17, standard library only; the scene
// compare/still_life is written in.
//
//     c++ -std=c++17 -O1 -o tracer tracer.cpp
//     ./tracer 235,285 525,225 > mine.jsonl
//     rayscope compare mine.jsonl compare/still_life
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

const double EPSILON = 1e-6;  // hits up to here are the surface that the ray starts on
const double INFINITE = std::numeric_limits<double>::infinity();

struct V { double x, y, z; };
V operator+(V a, V b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
V operator-(V a, V b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
V operator*(V a, V b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
V operator*(V a, double s) { return {a.x * s, a.y * s, a.z * s}; }
double dot(V a, V b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
V unit(V a) { return a * (1 / std::sqrt(dot(a, a))); }
V cross(V a, V b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
V reflect(V d, V n) { return d - n * (2 * dot(d, n)); }
double radians(double degrees) { return degrees * std::acos(-1.0) / 180; }

// Every number with all of its digits.
std::string text(double x) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.17g", x);
    return buffer;
}
std::string text(V v) { return "[" + text(v.x) + ", " + text(v.y) + ", " + text(v.z) + "]"; }
std::string quoted(const std::string& s) { return "\"" + s + "\""; }
void say(const std::string& members) { std::printf("{%s}\n", members.c_str()); }

// An affine map: three columns, and a translation.
struct Map {
    V a, b, c, move;
    V linear(V v) const { return a * v.x + b * v.y + c * v.z; }
    V point(V p) const { return linear(p) + move; }
    V transposed(V v) const { return {dot(a, v), dot(b, v), dot(c, v)}; }
    Map after(const Map& m) const { return {linear(m.a), linear(m.b), linear(m.c), point(m.move)}; }
    Map inverse() const {
        V r[3] = {cross(b, c), cross(c, a), cross(a, b)};
        double k = 1 / dot(a, r[0]);
        Map m{{r[0].x * k, r[1].x * k, r[2].x * k}, {r[0].y * k, r[1].y * k, r[2].y * k}, {r[0].z * k, r[1].z * k, r[2].z * k}, {0, 0, 0}};
        m.move = m.linear(move) * -1;
        return m;
    }
};
Map scale(V s) { return {{s.x, 0, 0}, {0, s.y, 0}, {0, 0, s.z}, {0, 0, 0}}; }
Map translate(V t) { return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, t}; }
Map about_y(double degrees) {
    double c = std::cos(radians(degrees)), s = std::sin(radians(degrees));
    return {{c, 0, -s}, {0, 1, 0}, {s, 0, c}, {0, 0, 0}};
}
Map about_z(double degrees) {
    double c = std::cos(radians(degrees)), s = std::sin(radians(degrees));
    return {{c, s, 0}, {-s, c, 0}, {0, 0, 1}, {0, 0, 0}};
}

struct Material {
    V ambient, diffuse, specular;
    double exponent, reflectivity, transparency, index;
};
const Material FLOOR{{0.43, 0.38, 0.31}, {0.43, 0.38, 0.31}, {0, 0, 0}, 1, 0, 0, 1};
const Material STONE{{0.5, 0.42, 0.36}, {0.5, 0.42, 0.36}, {0.2, 0.2, 0.2}, 20, 0, 0, 1};
const Material LACQUER{{0.1, 0.2, 0.42}, {0.1, 0.2, 0.42}, {0.5, 0.5, 0.5}, 40, 0.3, 0, 1};
const Material GLAZE{{0.5, 0.12, 0.08}, {0.5, 0.12, 0.08}, {0.4, 0.4, 0.4}, 30, 0, 0, 1};
const Material GLASS{{0.012, 0.016, 0.016}, {0.012, 0.016, 0.016}, {0.7, 0.7, 0.7}, 100, 0.08, 0.9, 1.5};

struct Cut { double t; V n; };  // where a line crosses a generic shape
using Shape = std::function<std::vector<Cut>(V s, V c)>;

std::vector<double> quadratic(double a, double b, double c) {
    double d = b * b - a * c;
    if (d <= 0 || a <= 0) return {};
    return {(-b - std::sqrt(d)) / a, (-b + std::sqrt(d)) / a};
}
std::vector<Cut> sphere(V s, V c) {
    std::vector<Cut> found;
    for (double t : quadratic(dot(c, c), dot(s, c), dot(s, s) - 1)) found.push_back({t, s + c * t});
    return found;
}
std::vector<Cut> plane(V s, V c) {
    if (c.z == 0) return {};
    return {{-s.z / c.z, {0, 0, 1}}};
}
std::vector<Cut> cylinder(V s, V c) {
    std::vector<Cut> found;
    for (double t : quadratic(c.x * c.x + c.y * c.y, s.x * c.x + s.y * c.y, s.x * s.x + s.y * s.y - 1)) {
        V p = s + c * t;
        if (p.z >= 0 && p.z <= 1) found.push_back({t, {p.x, p.y, 0}});
    }
    for (double z : {0.0, 1.0}) {
        double t = (z - s.z) / c.z;
        V p = s + c * t;
        if (p.x * p.x + p.y * p.y <= 1) found.push_back({t, {0, 0, 2 * z - 1}});
    }
    std::sort(found.begin(), found.end(), [](const Cut& a, const Cut& b) { return a.t < b.t; });
    return found;
}
std::vector<Cut> cube(V s, V c) {
    Cut enter{-INFINITE, {}}, leave{INFINITE, {}};
    for (V axis : {V{1, 0, 0}, V{0, 1, 0}, V{0, 0, 1}}) {
        double start = dot(s, axis), along = dot(c, axis);
        if (along == 0 && std::abs(start) > 1) return {};
        for (double side : {-1.0, 1.0}) {
            double t = (side - start) / along;
            if (side * along < 0 && t > enter.t) enter = {t, axis * side};
            if (side * along > 0 && t < leave.t) leave = {t, axis * side};
        }
    }
    if (enter.t >= leave.t) return {};
    return {enter, leave};
}

struct Leaf { std::string name; Shape shape; Map inverse; };
struct Object {  // one leaf, or the difference of two
    std::string name;
    Material material;
    std::vector<Leaf> leaves;
};
struct Light { std::string name; bool is_point; V place, colour; };
struct Hit { double t; V n; const Leaf* leaf; bool turned; };

const std::vector<Object> OBJECTS{
    {"floor", FLOOR, {{"floor", plane, translate({0, 0, 0}).inverse()}}},
    {"pillar", STONE, {{"pillar", cylinder, translate({-2.4, 1.2, 0.25}).after(about_y(20)).after(scale({0.55, 0.4, 1.6})).inverse()}}},
    {"block", LACQUER, {{"block", cube, translate({2.1, 0.9, 0.6}).after(about_z(30)).after(scale({0.7, 0.5, 0.6})).inverse()}}},
    {"egg", STONE, {{"egg", sphere, translate({1.5, -1.6, 0.55}).after(about_y(50)).after(scale({0.4, 0.4, 0.65})).inverse()}}},
    {"ball", GLASS, {{"ball", sphere, translate({-0.9, -1.3, 0.8}).after(scale({0.75, 0.75, 0.75})).inverse()}}},
    {"bowl", GLAZE,
     {{"outside", sphere, translate({0.2, 1.3, 0.95}).after(scale({0.95, 0.95, 0.95})).inverse()},
      {"hollow", sphere, translate({0.2, 1.3, 0.95}).after(translate({0.1, -0.3, 0.35})).after(scale({0.8, 0.8, 0.8})).inverse()}}},
};
const std::vector<Light> LIGHTS{{"lamp", true, {-5, -6, 8}, {1, 0.93, 0.8}}, {"sky", false, {3, -2, 4}, {0.2, 0.24, 0.3}}};
const V AMBIENT{0.2, 0.2, 0.2}, BACKGROUND{0.46, 0.6, 0.78};
const V EYE{0.6, -8.2, 3.6}, LOOK_AT{0.1, 0, 0.8};
const double WIDTH = 640, HEIGHT = 480, FIELD_OF_VIEW = 34;
const int DEPTH = 4;

std::vector<Hit> boundaries(const Object& object, V o, V d) {
    std::vector<Hit> all, result;
    for (const Leaf& leaf : object.leaves) {
        V s = leaf.inverse.point(o), c = leaf.inverse.linear(d);
        std::string times;
        for (const Cut& cut : leaf.shape(s, c)) {
            all.push_back({cut.t, cut.n, &leaf, &leaf != &object.leaves[0]});
            times += (times.empty() ? "" : ", ") + text(cut.t);
        }
        say("\"object\": " + quoted(object.name) + ", \"leaf\": " + quoted(leaf.name) + ", \"generic_origin\": " + text(s) +
            ", \"generic_direction\": " + text(c) + ", \"hits\": [" + times + "]");
    }
    std::stable_sort(all.begin(), all.end(), [](const Hit& a, const Hit& b) { return a.t < b.t; });
    bool in_left = false, in_right = false, was = false;
    for (const Hit& hit : all) {
        (hit.turned ? in_right : in_left) ^= true;
        bool now = in_left && !in_right;
        if (now != was) result.push_back(hit);
        was = now;
    }
    return result;
}

double arriving(const Light& light, V p, V to_light) {
    say("\"ray\": \"shadow\", \"light\": " + quoted(light.name) + ", \"origin\": " + text(p) + ", \"direction\": " + text(to_light));
    double end = light.is_point ? 1 : INFINITE, share = 1;
    for (const Object& object : OBJECTS)
        for (const Hit& hit : boundaries(object, p, to_light))
            if (hit.t > EPSILON && hit.t < end) share *= object.material.transparency;
    say("\"light\": " + quoted(light.name) + ", \"lit\": " + (share > 0 ? "true" : "false"));
    return share;
}

std::optional<V> refract(V outward, V n, V direction, double index) {
    bool enters = dot(outward, direction) < 0;
    double n1 = enters ? 1 : index, n2 = enters ? index : 1, eta = n1 / n2;
    V d = unit(direction);
    double cosine = -dot(d, n), w = 1 - eta * eta * (1 - cosine * cosine);
    std::optional<V> refracted;
    if (w >= 0) refracted = unit(d * eta + n * (eta * cosine - std::sqrt(w)));
    say("\"refracted\": " + (refracted ? text(*refracted) : "null") + ", \"n1\": " + text(n1) + ", \"n2\": " + text(n2));
    return refracted;
}

V trace(const char* kind, V o, V d, int depth);

V shade(const Object& object, const Hit& hit, V o, V d, int depth) {
    const Material& m = object.material;
    V p = o + d * hit.t, outward = unit(hit.leaf->inverse.transposed(hit.n)) * (hit.turned ? -1 : 1);
    V n = dot(outward, d) > 0 ? outward * -1 : outward, v = unit(d * -1);
    say("\"hit\": " + quoted(object.name) + ", \"leaf\": " + quoted(hit.leaf->name) + ", \"t\": " + text(hit.t) + ", \"point\": " + text(p) +
        ", \"outward\": " + text(outward) + ", \"normal\": " + text(n));
    V colour = m.ambient * AMBIENT;
    for (const Light& light : LIGHTS) {
        V to_light = light.is_point ? light.place - p : unit(light.place), l = unit(to_light);
        double lit = dot(n, l) > 0 ? arriving(light, p, to_light) : 0;
        V diffuse = light.colour * lit * m.diffuse * std::max(0.0, dot(n, l));
        V specular = light.colour * lit * m.specular * std::pow(std::max(0.0, dot(reflect(l * -1, n), v)), m.exponent);
        say("\"light\": " + quoted(light.name) + ", \"towards\": " + text(l) + ", \"diffuse\": " + text(diffuse) + ", \"specular\": " + text(specular));
        colour = colour + diffuse + specular;
    }
    if (depth == DEPTH || (m.reflectivity == 0 && m.transparency == 0)) return colour;
    std::optional<V> refracted;
    if (m.transparency > 0) refracted = refract(outward, n, d, m.index);
    double mirrors = m.reflectivity + (refracted ? 0 : m.transparency);
    if (mirrors > 0) colour = colour + trace("reflected", p, reflect(d, n), depth + 1) * mirrors;
    if (refracted) colour = colour + trace("refracted", p, *refracted, depth + 1) * m.transparency;
    return colour;
}

V trace(const char* kind, V o, V d, int depth) {
    say("\"ray\": " + quoted(kind) + ", \"origin\": " + text(o) + ", \"direction\": " + text(d));
    const Object* seen = nullptr;
    Hit best{INFINITE, {}, nullptr, false};
    for (const Object& object : OBJECTS)
        for (const Hit& hit : boundaries(object, o, d))
            if (hit.t > EPSILON && hit.t < best.t) seen = &object, best = hit;
    if (!seen) say("\"hit\": null");
    V colour = seen ? shade(*seen, best, o, d, depth) : BACKGROUND;
    say("\"colour\": " + text(colour));
    return colour;
}

void pixel(int x, int y) {
    say("\"pixel\": [" + std::to_string(x) + ", " + std::to_string(y) + "]");
    V forward = unit(LOOK_AT - EYE), right = unit(cross(forward, {0, 0, 1})), up = cross(right, forward);
    double h = std::tan(radians(FIELD_OF_VIEW) / 2);
    double a = (2 * (x + 0.5) / WIDTH - 1) * h * WIDTH / HEIGHT, b = (1 - 2 * (y + 0.5) / HEIGHT) * h;
    trace("camera", EYE, forward + right * a + up * b, 0);
}

int main(int count, char** arguments) {
    int x = 235, y = 285;
    if (count < 2) pixel(x, y);
    for (int k = 1; k < count; k++)
        if (std::sscanf(arguments[k], "%d,%d", &x, &y) == 2) pixel(x, y);
}
