// Pinned rods of the paper's element in motion, written from the paper alone, with mistakes to choose from.
//
// Reads a scene as lines of words on standard input (`motion.py` writes them), prints the motion as CSV. The shape functions come
// from the polynomial (A.1) and the nodal conditions (A.2), the force from the energy in the rod's own axes. Constraints are
// linear in the coordinates: C (q - q_0) = 0, eliminated from the accelerations.
//
//   motion --method NAME --step H [--print positions|velocities|all] [--mistake NAME]... < scene

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <iostream>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

using std::array;
using std::pair;
using std::string;
using std::vector;

using Vector = vector<double>;

static std::set<string> mistakes;

static bool made(const char* name) { return mistakes.count(name) > 0; }

// ------------------------------------------------------------------------------------------------------ linear algebra

struct Matrix {
    size_t rows = 0, cols = 0;
    Vector data;
    Matrix() = default;
    Matrix(size_t r, size_t c) : rows(r), cols(c), data(r * c, 0.0) {}
    double& operator()(size_t i, size_t j) { return data[i * cols + j]; }
    double operator()(size_t i, size_t j) const { return data[i * cols + j]; }
};

static Vector operator*(const Matrix& a, const Vector& x) {
    Vector out(a.rows, 0.0);
    for (size_t i = 0; i < a.rows; ++i)
        for (size_t j = 0; j < a.cols; ++j) out[i] += a(i, j) * x[j];
    return out;
}

static Matrix operator*(const Matrix& a, const Matrix& b) {
    Matrix out(a.rows, b.cols);
    for (size_t i = 0; i < a.rows; ++i)
        for (size_t k = 0; k < a.cols; ++k)
            for (size_t j = 0; j < b.cols; ++j) out(i, j) += a(i, k) * b(k, j);
    return out;
}

static Matrix transposed(const Matrix& a) {
    Matrix out(a.cols, a.rows);
    for (size_t i = 0; i < a.rows; ++i)
        for (size_t j = 0; j < a.cols; ++j) out(j, i) = a(i, j);
    return out;
}

static Matrix inverse(Matrix a) {
    const size_t n = a.rows;
    Matrix out(n, n);
    for (size_t i = 0; i < n; ++i) out(i, i) = 1;
    for (size_t k = 0; k < n; ++k) {
        size_t best = k;
        for (size_t i = k + 1; i < n; ++i)
            if (std::abs(a(i, k)) > std::abs(a(best, k))) best = i;
        if (a(best, k) == 0) throw std::runtime_error("a matrix is singular");
        for (size_t j = 0; j < n; ++j) std::swap(a(k, j), a(best, j)), std::swap(out(k, j), out(best, j));
        const double pivot = a(k, k);
        for (size_t j = 0; j < n; ++j) a(k, j) /= pivot, out(k, j) /= pivot;
        for (size_t i = 0; i < n; ++i) {
            const double factor = a(i, k);
            if (i == k || factor == 0) continue;
            for (size_t j = 0; j < n; ++j) a(i, j) -= factor * a(k, j), out(i, j) -= factor * out(k, j);
        }
    }
    return out;
}

static void add(Vector& x, double factor, const Vector& y) {
    for (size_t i = 0; i < x.size(); ++i) x[i] += factor * y[i];
}

static double largest(const Vector& x) {
    double out = 0;
    for (double entry : x) out = std::max(out, std::abs(entry));
    return out;
}

// Gauss points and weights on [-1, 1]: roots of Legendre's polynomial by Newton's iteration.
static vector<pair<double, double>> gauss(int n) {
    vector<pair<double, double>> out;
    for (int k = 1; k <= n; ++k) {
        double x = std::cos(std::acos(-1.0) * (k - 0.25) / (n + 0.5)), slope = 1;
        for (int step = 0; step < 60; ++step) {
            double p = 1, before = 0;
            for (int j = 0; j < n; ++j) {
                const double next = ((2 * j + 1) * x * p - j * before) / (j + 1);
                before = p, p = next;
            }
            slope = n * (x * p - before) / (x * x - 1);
            x -= p / slope;
        }
        out.push_back({x, 2 / ((1 - x * x) * slope * slope)});
    }
    return out;
}

// --------------------------------------------------------------------------------------------------------------- scene

// Linear between its entries, constant outside.
struct History {
    vector<pair<double, double>> entries;
    double at(double t) const {
        if (entries.empty()) return 1;
        if (t <= entries.front().first) return entries.front().second;
        for (size_t k = 1; k < entries.size(); ++k) {
            const auto [t0, v0] = entries[k - 1];
            const auto [t1, v1] = entries[k];
            if (t < t1) return v0 + (v1 - v0) * (t - t0) / (t1 - t0);
        }
        return entries.back().second;
    }
};

struct Rod {
    array<double, 2> from{}, to{};
    size_t elements = 1, first = 0; // the first of its nodal vectors
    double E = 0, nu = 0, rho = 0, alpha = 0, h = 0, w = 0;
    string model = "none";
    bool relaxed = false;
    History heat;
    size_t vectors() const { return 5 * elements + 2; }
    double length() const { return std::hypot(to[0] - from[0], to[1] - from[1]) / static_cast<double>(elements); }
    array<double, 2> axis() const {
        const double whole = length() * static_cast<double>(elements);
        return {(to[0] - from[0]) / whole, (to[1] - from[1]) / whole};
    }
    // r_y at a place.
    size_t section_at(const string& place) const {
        return vector_at(place) + (place == "middle" && elements % 2 == 1 ? 2 : 1);
    }
    // The nodal vector of a place: its first point, its last, or its middle.
    size_t vector_at(const string& place) const {
        if (place == "first") return first;
        if (place == "last") return first + 5 * elements;
        return first + 5 * (elements / 2) + (elements % 2 == 1 ? 2 : 0);
    }
};

struct Row {
    vector<pair<size_t, double>> entries; // coordinates with factors
};

struct Force {
    size_t vector;
    array<double, 2> value;
    History history;
};

struct Scene {
    vector<Rod> rods;
    vector<Row> rows;
    vector<Force> forces;
    vector<size_t> springs; // coordinates held by springs in place of constraints
    vector<pair<string, size_t>> points; // with the nodal vector of each
    array<double, 2> gravity{};
    double end = 0, interval = 0;
    size_t size() const {
        size_t out = 0;
        for (const Rod& rod : rods) out += 2 * rod.vectors();
        return out;
    }
};

static History read_history(std::istringstream& line) {
    History out;
    size_t count = 0;
    line >> count;
    for (size_t k = 0; k < count; ++k) {
        double t, value;
        line >> t >> value;
        out.entries.push_back({t, value});
    }
    return out;
}

static Scene read_scene(std::istream& input) {
    Scene scene;
    for (string text; std::getline(input, text);) {
        std::istringstream line(text);
        string word, place, other_place;
        size_t rod = 0, other = 0;
        line >> word;
        if (word == "rod") {
            Rod r;
            int relaxed = 0;
            line >> r.from[0] >> r.from[1] >> r.to[0] >> r.to[1] >> r.elements >> r.E >> r.nu >> r.rho >> r.alpha >> r.h >> r.w >>
                r.model >> relaxed;
            r.relaxed = relaxed == 1;
            r.heat = read_history(line);
            if (made("density")) r.rho *= 1.1;
            if (made("material-of-first") && !scene.rods.empty()) {
                const Rod& of = scene.rods.front();
                r.E = of.E, r.nu = of.nu, r.rho = of.rho, r.alpha = of.alpha;
            }
            if (made("mesh")) r.elements *= 2;
            r.first = scene.size() / 2;
            scene.rods.push_back(r);
        } else if (word == "pin") {
            line >> rod >> place >> other >> other_place;
            const size_t a = scene.rods.at(rod).vector_at(place), b = scene.rods.at(other).vector_at(other_place);
            for (size_t c = 0; c < 2; ++c) {
                if (made("pin-one-sided") && c == 1) continue;
                scene.rows.push_back({{{2 * a + c, -1.0}, {2 * b + c, 1.0}}});
            }
            if (made("welded")) {
                // r_y of the second rod is that of the first, turned by the angle between them.
                const auto [ax, ay] = scene.rods[rod].axis();
                const auto [bx, by] = scene.rods[other].axis();
                const double c = ax * bx + ay * by, s = ax * by - ay * bx;
                const size_t p = 2 * scene.rods[rod].section_at(place), q = 2 * scene.rods[other].section_at(other_place);
                scene.rows.push_back({{{q, 1.0}, {p, -c}, {p + 1, s}}});
                scene.rows.push_back({{{q + 1, 1.0}, {p, -s}, {p + 1, -c}}});
            }
        } else if (word == "fix") {
            string axis;
            line >> rod >> place >> axis;
            if (made("hinge-one-sided") && axis == "x") continue;
            const size_t held = 2 * scene.rods.at(rod).vector_at(place) + (axis == "y" ? 1u : 0u);
            if (made("hinge-spring")) {
                scene.springs.push_back(held);
                continue;
            }
            scene.rows.push_back({{{held, 1.0}}});
            if (made("hinge-clamped") && axis == "x") {
                const Rod& r = scene.rods.at(rod);
                const size_t section = r.vector_at(place) + 1;
                scene.rows.push_back({{{2 * section, r.axis()[0]}, {2 * section + 1, r.axis()[1]}}});
            }
        } else if (word == "clamp") {
            line >> rod;
            const Rod& r = scene.rods.at(rod);
            if (made("clamp-lost")) continue;
            scene.rows.push_back({{{2 * r.first + 2, r.axis()[0]}, {2 * r.first + 3, r.axis()[1]}}});
        } else if (word == "slide") {
            double x, y;
            line >> rod >> place >> x >> y;
            if (made("slide-across")) std::tie(x, y) = std::make_pair(-y, x);
            const size_t v = scene.rods.at(rod).vector_at(place);
            scene.rows.push_back({{{2 * v, -y}, {2 * v + 1, x}}});
        } else if (word == "force") {
            Force force{};
            line >> rod >> place >> force.value[0] >> force.value[1];
            force.vector = scene.rods.at(rod).vector_at(place);
            force.history = read_history(line);
            if (made("force-constant")) force.history.entries.clear();
            scene.forces.push_back(force);
        } else if (word == "gravity") {
            line >> scene.gravity[0] >> scene.gravity[1];
            if (made("gravity-9.81")) scene.gravity[1] = -9.81;
        } else if (word == "point") {
            line >> word >> rod >> place;
            scene.points.push_back({word, scene.rods.at(rod).vector_at(place)});
        } else if (word == "time") {
            line >> scene.end >> scene.interval;
        } else if (!word.empty()) {
            throw std::runtime_error("no such line: " + text);
        }
    }
    return scene;
}

// ------------------------------------------------------------------------------------------------------------- element

// The seven terms of (A.1) and their derivatives by x and by y.
static array<array<double, 7>, 3> terms(double x, double y) {
    return {{{1, x, y, x * y, x * x, x * x * x, x * x * y},
             {0, 1, 0, y, 2 * x, 3 * x * x, 2 * x * y},
             {0, 0, 1, x, 0, 0, x * x}}};
}

// Shape functions of an element: the polynomials that are 1 in one of the conditions (A.2) and 0 in the others.
struct Shapes {
    Matrix coefficients; // of the terms, by condition
    explicit Shapes(double l) {
        Matrix conditions(7, 7);
        const vector<pair<double, int>> at = {{0, 0}, {0, 2}, {l / 2, 0}, {l / 2, 1}, {l / 2, 2}, {l, 0}, {l, 2}};
        for (size_t i = 0; i < 7; ++i)
            for (size_t j = 0; j < 7; ++j) conditions(i, j) = terms(at[i].first, 0)[static_cast<size_t>(at[i].second)][j];
        coefficients = transposed(inverse(conditions));
    }
    array<array<double, 7>, 3> at(double x, double y) const {
        const auto t = terms(x, y);
        array<array<double, 7>, 3> out{};
        for (size_t d = 0; d < 3; ++d)
            for (size_t a = 0; a < 7; ++a)
                for (size_t k = 0; k < 7; ++k) out[d][a] += coefficients(a, k) * t[d][k];
        return out;
    }
};

// A Gauss point: derivatives of the shape functions, share of the volume.
struct Point {
    array<double, 7> x, y;
    double volume;
};

struct Element {
    vector<Point> points;
    Matrix mass{7, 7}; // for one component
    Vector weight = Vector(7, 0.0);
    explicit Element(const Rod& rod) {
        const double l = rod.length();
        const Shapes shapes(l);
        for (const auto& [xi, wx] : gauss(made("two-points") ? 2 : 5))
            for (const auto& [eta, wy] : gauss(3)) {
                const auto s = shapes.at(l * (1 + xi) / 2, rod.h * eta / 2);
                points.push_back({s[1], s[2], wx * wy * l * rod.h * rod.w / 4});
            }
        for (const auto& [xi, wx] : gauss(5))
            for (const auto& [eta, wy] : gauss(3)) {
                const auto s = shapes.at(l * (1 + xi) / 2, rod.h * eta / 2);
                const double m = rod.rho * wx * wy * l * rod.h * rod.w / 4;
                for (size_t a = 0; a < 7; ++a) {
                    weight[a] += m * s[0][a];
                    for (size_t b = 0; b < 7; ++b) mass(a, b) += m * s[0][a] * s[0][b];
                }
            }
        if (made("mass-lumped")) {
            double carried = 0;
            for (size_t a : {0u, 2u, 5u}) carried += mass(a, a);
            const double factor = rod.rho * l * rod.h * rod.w / carried;
            for (size_t a = 0; a < 7; ++a)
                for (size_t b = 0; b < 7; ++b) mass(a, b) *= a == b ? factor : 0;
        }
    }
};

// --------------------------------------------------------------------------------------------------------------- rods

class Rods {
  public:
    Matrix mass, to_acceleration;
    Vector start, weight;
    double late = 0; // time by which loads and heat lag behind

    explicit Rods(const Scene& s) : mass(s.size(), s.size()), start(s.size()), weight(s.size(), 0.0), scene(s) {
        for (const Rod& rod : scene.rods) {
            elements.emplace_back(rod);
            assemble(rod, elements.back());
            place(rod);
        }
        if (made("weight-lost")) std::fill(weight.begin(), weight.end(), 0.0);
        if (made("weight-doubled")) add(weight, 1, Vector(weight));
        if (made("weight-up")) for (double& f : weight) f = -f;
        to_acceleration = inverse(mass);
        if (!scene.rows.empty()) {
            Matrix C(scene.rows.size(), scene.size());
            for (size_t i = 0; i < scene.rows.size(); ++i)
                for (const auto& [at, factor] : scene.rows[i].entries) C(i, at) = factor;
            const Matrix by_mass = to_acceleration * transposed(C);
            const Matrix within = by_mass * inverse(C * by_mass) * transposed(by_mass);
            for (size_t i = 0; i < within.data.size(); ++i) to_acceleration.data[i] -= within.data[i];
        }
    }

    Vector acceleration(double now, const Vector& q, const Vector& v) const {
        const double t = std::max(now - late, 0.0);
        Vector force = weight;
        for (size_t at : scene.springs) force[at] -= 2e4 * (q[at] - start[at]);
        for (const Force& f : scene.forces)
            for (size_t c = 0; c < 2; ++c) force[2 * f.vector + c] += f.value[c] * f.history.at(t);
        for (size_t n = 0; n < scene.rods.size(); ++n) stresses(n, t, q, &force);
        if (made("damped")) add(force, -0.5, mass * v);
        return to_acceleration * force;
    }

    // Kinetic, strain and potential energy.
    array<double, 3> energies(double t, const Vector& q, const Vector& v) const {
        const Vector p = mass * v;
        double kinetic = 0, potential = 0, strain = 0;
        for (size_t i = 0; i < v.size(); ++i) kinetic += v[i] * p[i] / 2, potential -= weight[i] * q[i];
        for (size_t n = 0; n < scene.rods.size(); ++n) strain += stresses(n, t, q, nullptr);
        return {kinetic, strain, potential};
    }

  private:
    const Scene& scene;
    vector<Element> elements;

    void assemble(const Rod& rod, const Element& element) {
        for (size_t k = 0; k < rod.elements; ++k)
            for (size_t a = 0; a < 7; ++a)
                for (size_t c = 0; c < 2; ++c) {
                    const size_t i = 2 * (rod.first + 5 * k + a) + c;
                    const bool lost = made("weight-of-one-lost") && k == 1;
                    weight[i] += lost ? 0 : element.weight[a] * scene.gravity[c];
                    for (size_t b = 0; b < 7; ++b) {
                        double& entry = mass(i, 2 * (rod.first + 5 * k + b) + c);
                        const bool shared = k > 0 && a < 2 && b < 2;
                        entry = (made("mass-once") && shared ? 0 : entry) + element.mass(a, b);
                    }
                }
    }

    // Thermal strain along and across.
    array<double, 2> heat(const Rod& rod, double t) const {
        double dT = rod.heat.entries.empty() ? 0 : rod.heat.at(t);
        if (made("heat-ramped")) dT *= std::min(t / 0.1, 1.0);
        if (made("heat-quadratic")) dT *= std::pow(std::min(t / 0.2, 1.0), 2);
        if (made("heat-doubled")) dT *= 2;
        if (made("heat-half-more")) dT *= 1.5;
        if (made("heat-minus")) dT = -dT;
        if (made("heat-lost")) dT = 0;
        if (made("heat-of-the-other")) dT = scene.rods.front().heat.at(t);
        if (made("heat-at-once")) dT = rod.heat.entries.back().second;
        string model = rod.model;
        if (made("1d-for-2d") && model == "2d") model = "1d";
        else if (made("2d-for-1d") && model == "1d") model = "2d";
        const double strain = model == "none" ? 0 : rod.alpha * dT;
        return {strain, model == "2d" ? strain : 0};
    }

    void place(const Rod& rod) {
        const auto [tx, ty] = rod.axis();
        const auto strain = heat(rod, 0);
        const bool relaxed = rod.relaxed != made("relaxed-for-sudden");
        const double along = relaxed ? std::sqrt(1 + 2 * strain[0]) : 1, across = relaxed ? std::sqrt(1 + 2 * strain[1]) : 1;
        const double l = rod.length() * along;
        for (size_t v = 0; v < rod.vectors(); ++v) {
            const double at = l * (static_cast<double>(v / 5) + (v % 5 == 2 ? 0.5 : 0.0));
            double* r = &start[2 * (rod.first + v)];
            if (v % 5 == 0 || v % 5 == 2) r[0] = rod.from[0] + at * tx, r[1] = rod.from[1] + at * ty;
            else if (v % 5 == 3) r[0] = along * tx, r[1] = along * ty;
            else r[0] = -across * ty, r[1] = across * tx;
        }
    }

    // Strain energy of a rod; its elastic forces are subtracted from `force`.
    double stresses(size_t n, double t, const Vector& q, Vector* force) const {
        const Rod& rod = scene.rods[n];
        const auto eps_T = heat(rod, t);
        double nu = rod.nu;
        if (made("nu-0.3")) nu = 0.3;
        if (made("nu-lost")) nu = 0;
        const double lambda = rod.E * nu / ((1 + nu) * (1 - 2 * nu)), mu = rod.E / (2 * (1 + nu));
        const double shear = made("shear-once") ? 1 : 2;
        double energy = 0;
        for (size_t k = 0; k < rod.elements; ++k) {
            if (made("element-lost") && k + 1 == rod.elements) continue;
            const size_t first = 2 * (rod.first + 5 * k);
            for (const Point& p : elements[n].points) {
                double F[2][2] = {};
                for (size_t a = 0; a < 7; ++a)
                    for (size_t c = 0; c < 2; ++c) {
                        const double r = q[first + 2 * a + c];
                        F[c][0] += p.x[a] * r, F[c][1] += p.y[a] * r;
                    }
                const double e1 = (F[0][0] * F[0][0] + F[1][0] * F[1][0] - 1) / 2 - eps_T[0];
                const double e2 = (F[0][1] * F[0][1] + F[1][1] * F[1][1] - 1) / 2 - eps_T[1];
                const double e12 = (F[0][0] * F[0][1] + F[1][0] * F[1][1]) / 2;
                const double s1 = (lambda + 2 * mu) * e1 + lambda * e2, s2 = (lambda + 2 * mu) * e2 + lambda * e1;
                const double s12 = shear * mu * e12;
                energy += p.volume * (s1 * e1 + s2 * e2 + 2 * s12 * e12) / 2;
                if (!force) continue;
                for (size_t c = 0; c < 2; ++c) {
                    const double Px = p.volume * (F[c][0] * s1 + F[c][1] * s12), Py = p.volume * (F[c][0] * s12 + F[c][1] * s2);
                    for (size_t a = 0; a < 7; ++a) (*force)[first + 2 * a + c] -= p.x[a] * Px + p.y[a] * Py;
                }
            }
        }
        return energy;
    }
};

// ------------------------------------------------------------------------------------------------------------- methods

struct State {
    double t = 0;
    Vector q, v, a;
};

// Solves q = known + c a(t, q) by Newton's iteration with a matrix by differences, kept as long as it serves.
class Implicit {
  public:
    explicit Implicit(const Rods& r) : rods(r) {}

    void solve(double t, double c, const Vector& known, State& s) {
        s.q = known;
        add(s.q, c, s.a);
        for (int iteration = 0; iteration < 40; ++iteration) {
            s.a = rods.acceleration(t, s.q, s.v);
            Vector residual = known;
            add(residual, c, s.a);
            add(residual, -1, s.q);
            if (c != made_for || iteration % 4 == 3) renew(t, c, s);
            const Vector correction = matrix * residual;
            add(s.q, 1, correction);
            if (!(largest(correction) < 1e3)) break;
            if (largest(correction) < 3e-15) {
                s.a = rods.acceleration(t, s.q, s.v);
                return;
            }
        }
        throw std::runtime_error("Newton's iteration does not converge");
    }

  private:
    const Rods& rods;
    double made_for = -1;
    Matrix matrix;

    void renew(double t, double c, const State& s) {
        const size_t n = s.q.size();
        Matrix tangent(n, n);
        for (size_t j = 0; j < n; ++j) {
            Vector q = s.q;
            q[j] += 1e-7;
            const Vector a = rods.acceleration(t, q, s.v);
            for (size_t i = 0; i < n; ++i) tangent(i, j) = (i == j ? 1.0 : 0.0) - c * (a[i] - s.a[i]) / 1e-7;
        }
        matrix = inverse(tangent);
        made_for = c;
    }
};

class Method {
  public:
    Method(const Rods& r, string word, double step) : rods(r), name(std::move(word)), h(step), implicit(r) {}

    void step(State& s) {
        if (name == "verlet") return verlet(s);
        if (name == "rk4") return runge_kutta(s);
        if (name == "newmark") return newmark(s, 0.25, 0.5);
        if (name == "newmark-damped") return newmark(s, 0.3025, 0.6);
        if (name == "generalized-alpha") return generalized_alpha(s);
        if (name == "euler-implicit") return newmark(s, 1.0, 1.0);
        if (name == "euler-half-implicit") return half_implicit(s);
        throw std::runtime_error("no such method: " + name);
    }

  private:
    const Rods& rods;
    string name;
    double h;
    Implicit implicit;
    Vector mean; // the generalized-alpha method's acceleration-like variable

    void verlet(State& s) {
        add(s.v, h / 2, s.a);
        add(s.q, h, s.v);
        s.t += h;
        s.a = rods.acceleration(s.t, s.q, s.v);
        add(s.v, h / 2, s.a);
    }

    // Velocity first, position with it.
    void half_implicit(State& s) {
        add(s.v, h, s.a);
        add(s.q, h, s.v);
        s.t += h;
        s.a = rods.acceleration(s.t, s.q, s.v);
    }

    void runge_kutta(State& s) {
        const double half = h / 2;
        const Vector v1 = s.v, a1 = rods.acceleration(s.t, s.q, s.v);
        auto at = [&](double dt, const Vector& dq, const Vector& dv, Vector& v, Vector& a) {
            Vector q = s.q;
            v = s.v;
            add(q, dt, dq), add(v, dt, dv);
            a = rods.acceleration(s.t + dt, q, v);
        };
        Vector v2, a2, v3, a3, v4, a4;
        at(half, v1, a1, v2, a2);
        at(half, v2, a2, v3, a3);
        at(h, v3, a3, v4, a4);
        const double w[4] = {1, 2, 2, made("rk4-last-weight") ? 1.001 : 1};
        for (size_t i = 0; i < s.q.size(); ++i) {
            s.q[i] += h / 6 * (w[0] * v1[i] + w[1] * v2[i] + w[2] * v3[i] + w[3] * v4[i]);
            s.v[i] += h / 6 * (w[0] * a1[i] + w[1] * a2[i] + w[2] * a3[i] + w[3] * a4[i]);
        }
        s.t += h;
        s.a = rods.acceleration(s.t, s.q, s.v);
    }

    void newmark(State& s, double beta, double gamma) {
        Vector known = s.q, before = s.a;
        add(known, h, s.v);
        add(known, h * h * (0.5 - beta) * (beta == 1 ? 0 : 1), before);
        Vector v = s.v;
        add(v, h * (1 - gamma), before);
        implicit.solve(s.t + h, h * h * beta, known, s);
        add(v, h * gamma, s.a);
        s.v = v;
        s.t += h;
    }

    // Chung and Hulbert's, with a spectral radius of 0.8 at infinity; M a_m = f at q_f.
    void generalized_alpha(State& s) {
        const double rho = 0.8, am = (2 * rho - 1) / (rho + 1), af = rho / (rho + 1);
        const double gamma = 0.5 - am + af, beta = 0.25 * (1 - am + af) * (1 - am + af);
        if (mean.empty()) mean = s.a;
        // mean' (1 - am) + am mean = (1 - af) a(q') + af a(q), with the true accelerations a.
        Vector known = s.q;
        add(known, h, s.v);
        add(known, h * h * (0.5 - beta), mean);
        Vector rest(s.q.size());
        for (size_t i = 0; i < rest.size(); ++i) rest[i] = (af * s.a[i] - am * mean[i]) / (1 - am);
        add(known, h * h * beta, rest);
        implicit.solve(s.t + h, h * h * beta * (1 - af) / (1 - am), known, s);
        Vector next = rest;
        add(next, (1 - af) / (1 - am), s.a);
        add(s.v, h * (1 - gamma), mean);
        add(s.v, h * gamma, next);
        mean = next;
        s.t += h;
    }
};

// ---------------------------------------------------------------------------------------------------------------- main

static void print(const Scene& scene, const Rods& rods, const State& s, const string& what) {
    std::printf("%.10g", s.t);
    for (const auto& [name, at] : scene.points) std::printf(",%.15g,%.15g", s.q[2 * at], s.q[2 * at + 1]);
    if (what != "positions")
        for (const auto& [name, at] : scene.points) std::printf(",%.15g,%.15g", s.v[2 * at], s.v[2 * at + 1]);
    if (what == "all")
        for (double energy : rods.energies(s.t, s.q, s.v)) std::printf(",%.15g", energy);
    std::printf("\n");
}

static int run(const string& method, double step, const string& what) {
    const Scene scene = read_scene(std::cin);
    Rods rods(scene);
    if (made("load-late")) rods.late = step;
    State s;
    s.q = rods.start, s.v = Vector(s.q.size(), 0.0);
    s.a = rods.acceleration(0, s.q, s.v);
    std::printf("# step = %.10g\nt", step);
    for (const auto& [name, at] : scene.points) std::printf(",%s_x,%s_y", name.c_str(), name.c_str());
    if (what != "positions")
        for (const auto& [name, at] : scene.points) std::printf(",%s_vx,%s_vy", name.c_str(), name.c_str());
    if (what == "all") std::printf(",kinetic,strain,potential");
    std::printf("\n");
    Method steps(rods, method, step);
    const long per_sample = std::lround(scene.interval / step), samples = std::lround(scene.end / scene.interval);
    if (std::abs(static_cast<double>(per_sample) * step - scene.interval) > 1e-12)
        throw std::runtime_error("the interval has to be a multiple of the step");
    print(scene, rods, s, what);
    for (long n = 1; n <= samples; ++n) {
        for (long k = 0; k < per_sample; ++k) steps.step(s);
        s.t = static_cast<double>(n) * scene.interval;
        print(scene, rods, s, what);
    }
    return 0;
}

int main(int count, char** words) {
    try {
        string method = "verlet", what = "positions";
        double step = 0;
        for (int i = 1; i + 1 < count; i += 2) {
            const string option = words[i], value = words[i + 1];
            if (option == "--method") method = value;
            else if (option == "--step") step = std::stod(value);
            else if (option == "--print") what = value;
            else if (option == "--mistake") mistakes.insert(value);
            else throw std::runtime_error("no such option: " + option);
        }
        if (!(step > 0)) throw std::runtime_error("--step has to be over 0");
        return run(method, step, what);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "motion: %s\n", error.what());
        return 2;
    }
}
