// The planar thermo-elastic ANCF beam of Peng et al. (2018) and the Euler-Bernoulli cable element, written from the
// paper alone to try `ancf conform`. The program answers its questions, a line of JSON each. It can be told to make a
// mistake, to calculate in single precision, to answer in another convention or to format its answers badly.
//
// The beam's forces are found in two ways. `--route stress` (the default) integrates stress times the variation of the
// Green-Lagrange strain. `--route paper` goes through S_a, S_b, S_c and K, as the paper does.
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using std::array;
using std::pair;
using std::runtime_error;
using std::string;
using std::vector;

// ---------------------------------------------------------------------------------------------------------- options

struct Options {
    std::set<string> mistakes, only;
    string convention, convention_in, memory, given, talk, declare, route = "stress";
    int digits = 0;    // significant digits printed; 0: all
    int decimals = -1; // decimals printed; -1: not fixed
    bool single = false;
};

static Options options;

// Whether the program makes this mistake.
static bool m(const char* name) { return options.mistakes.count(name) > 0; }

// ------------------------------------------------------------------------------------------------------------- JSON

struct Json {
    enum Kind { null, boolean, number, text, list, object } kind = null;
    bool truth = false;
    double value = 0;
    string words;
    vector<Json> items;
    vector<pair<string, Json>> members;

    const Json* find(const string& key) const {
        for (const auto& member : members)
            if (member.first == key) return &member.second;
        return nullptr;
    }
    const Json& at(const string& key) const {
        const Json* found = find(key);
        if (!found) throw runtime_error(key + " is missing");
        return *found;
    }
};

class Parser {
  public:
    explicit Parser(const string& text) : s(text) {}
    Json document() {
        Json whole = any();
        space();
        if (i != s.size()) throw runtime_error("JSON: something follows the document");
        return whole;
    }

  private:
    const string& s;
    size_t i = 0;

    void space() { while (i < s.size() && std::isspace(static_cast<unsigned char>(s[i]))) ++i; }
    bool next(char c) {
        space();
        if (i < s.size() && s[i] == c) { ++i; return true; }
        return false;
    }
    void expect(char c) {
        if (!next(c)) throw runtime_error(string("JSON: expected ") + c);
    }
    string quoted() {
        expect('"');
        string out;
        while (i < s.size() && s[i] != '"') {
            if (s[i] == '\\' && i + 1 < s.size()) ++i;
            out += s[i++];
        }
        ++i;
        return out;
    }
    Json any() {
        space();
        Json j;
        if (i >= s.size()) throw runtime_error("JSON: the line ends early");
        if (s[i] == '{') {
            j.kind = Json::object;
            ++i;
            if (next('}')) return j;
            do {
                space();
                string key = quoted();
                expect(':');
                j.members.emplace_back(key, any());
            } while (next(','));
            expect('}');
        } else if (s[i] == '[') {
            j.kind = Json::list;
            ++i;
            if (next(']')) return j;
            do j.items.push_back(any()); while (next(','));
            expect(']');
        } else if (s[i] == '"') {
            j.kind = Json::text;
            j.words = quoted();
        } else if (s.compare(i, 4, "true") == 0) {
            j.kind = Json::boolean, j.truth = true, i += 4;
        } else if (s.compare(i, 5, "false") == 0) {
            j.kind = Json::boolean, i += 5;
        } else if (s.compare(i, 4, "null") == 0) {
            i += 4;
        } else {
            char* end = nullptr;
            j.kind = Json::number;
            j.value = std::strtod(s.c_str() + i, &end);
            if (end == s.c_str() + i) throw runtime_error("JSON: expected a value");
            i = static_cast<size_t>(end - s.c_str());
        }
        return j;
    }
};

// ---------------------------------------------------------------------------------------------------------- numbers

template <class T> using Vec = vector<T>;

// A value with its shape: lengths of the nested lists, outer first.
template <class T> struct Tensor {
    vector<int> shape;
    Vec<T> data;
};

template <class T> struct Matrix {
    int rows, cols;
    Vec<T> data;
    Matrix(int r, int c) : rows(r), cols(c), data(static_cast<size_t>(r * c), T(0)) {}
    T& operator()(int i, int j) { return data[static_cast<size_t>(i * cols + j)]; }
    const T& operator()(int i, int j) const { return data[static_cast<size_t>(i * cols + j)]; }
    Tensor<T> tensor() const { return {{rows, cols}, data}; }
};

template <class T> Matrix<T> transposed(const Matrix<T>& a) {
    Matrix<T> out(a.cols, a.rows);
    for (int i = 0; i < a.rows; ++i)
        for (int j = 0; j < a.cols; ++j) out(j, i) = a(i, j);
    return out;
}

template <class T> Vec<T> times(const Matrix<T>& a, const Vec<T>& x) {
    Vec<T> out(static_cast<size_t>(a.rows), T(0));
    for (int i = 0; i < a.rows; ++i)
        for (int j = 0; j < a.cols; ++j) out[i] += a(i, j) * x[j];
    return out;
}

template <class T> T dot(const Vec<T>& a, const Vec<T>& b) {
    T sum = 0;
    for (size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

// Solves a x = b by Gauss's elimination with scaled pivoting of rows.
template <class T> Vec<T> solve(Matrix<T> a, Vec<T> b) {
    const int n = a.rows;
    Vec<T> scale(static_cast<size_t>(n), T(0));
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) scale[i] = std::max(scale[i], std::abs(a(i, j)));
    for (int k = 0; k < n; ++k) {
        int best = k;
        for (int i = k + 1; i < n; ++i)
            if (std::abs(a(i, k)) * scale[best] > std::abs(a(best, k)) * scale[i]) best = i;
        if (a(best, k) == T(0)) throw runtime_error("a matrix is singular");
        for (int j = 0; j < n; ++j) std::swap(a(k, j), a(best, j));
        std::swap(b[k], b[best]);
        std::swap(scale[k], scale[best]);
        for (int i = k + 1; i < n; ++i) {
            const T factor = a(i, k) / a(k, k);
            for (int j = k; j < n; ++j) a(i, j) -= factor * a(k, j);
            b[i] -= factor * b[k];
        }
    }
    for (int i = n - 1; i >= 0; --i) {
        for (int j = i + 1; j < n; ++j) b[i] -= a(i, j) * b[j];
        b[i] /= a(i, i);
    }
    return b;
}

// Gauss points and weights on [-1, 1].
template <class T> vector<pair<T, T>> gauss(int n) {
    switch (n) {
    case 1: return {{T(0), T(2)}};
    case 2: return {{T(-1) / std::sqrt(T(3)), T(1)}, {T(1) / std::sqrt(T(3)), T(1)}};
    case 3: {
        const T p = std::sqrt(T(3) / T(5));
        if (m("18-weights-exchanged")) return {{-p, T(8) / T(9)}, {T(0), T(5) / T(9)}, {p, T(8) / T(9)}};
        return {{-p, T(5) / T(9)}, {T(0), T(8) / T(9)}, {p, T(5) / T(9)}};
    }
    case 4: {
        const T root = std::sqrt(T(6) / T(5));
        const T p = std::sqrt((3 - 2 * root) / 7), q = std::sqrt((3 + 2 * root) / 7);
        const T wp = (18 + std::sqrt(T(30))) / 36, wq = (18 - std::sqrt(T(30))) / 36;
        return {{-q, wq}, {-p, wp}, {p, wp}, {q, wq}};
    }
    default: {
        const T root = std::sqrt(T(10) / T(7));
        const T p = std::sqrt(5 - 2 * root) / 3, q = std::sqrt(5 + 2 * root) / 3;
        const T wp = (322 + 13 * std::sqrt(T(70))) / 900, wq = (322 - 13 * std::sqrt(T(70))) / 900;
        T middle = T(128) / T(225);
        if (m("18-middle-weight")) middle = T(128) / T(255);
        return {{-q, wq}, {-p, wp}, {T(0), middle}, {p, wp}, {q, wq}};
    }
    }
}

// ------------------------------------------------------------------------------------------------------------ state

template <class T> struct State {
    T l, h, w, theta, E, nu, rho, alpha, dT;
    string model;
    Vec<T> e0, e, edot, gravity;
    vector<array<T, 2>> points;
};

// Intermediate values that came with the question, flattened.
template <class T> using Given = std::map<string, Vec<T>>;

template <class T> void flatten(const Json& j, Vec<T>& out) {
    if (j.kind == Json::number) out.push_back(static_cast<T>(j.value));
    for (const Json& item : j.items) flatten(item, out);
}

template <class T> T scalar(const Json& state, const char* key) {
    const Json& j = state.at(key);
    if (j.kind != Json::number || !std::isfinite(j.value)) throw runtime_error(string(key) + " has to be a number");
    return static_cast<T>(j.value);
}

template <class T> Vec<T> numbers(const Json& state, const char* key, size_t length) {
    const Json& j = state.at(key);
    if (j.kind != Json::list || j.items.size() != length)
        throw runtime_error(string(key) + " has to be " + std::to_string(length) + " numbers");
    Vec<T> out;
    for (const Json& item : j.items) {
        if (item.kind != Json::number) throw runtime_error(string(key) + " has to be numbers");
        out.push_back(static_cast<T>(item.value));
    }
    return out;
}

// Layout of the nodal coordinates in another convention: coordinate i there is `scale[i]` times `place[i]` of (4).
template <class T> struct Layout {
    vector<int> place, vectors; // of coordinates; of nodal vectors
    Vec<T> scale, vector_scale;
};

template <class T> Layout<T> layout(const string& name, bool cable, T l, T h) {
    const int n = cable ? 4 : 7;
    Layout<T> out;
    for (int a = 0; a < n; ++a) out.vectors.push_back(a);
    if (name == "by-kind") out.vectors = cable ? vector<int>{0, 2, 1, 3} : vector<int>{0, 2, 5, 1, 3, 4, 6};
    if (name == "ends-first" && !cable) out.vectors = {0, 1, 5, 6, 2, 3, 4};
    for (int a = 0; a < n; ++a) {
        const int old = out.vectors[a];
        T s = 1;
        if (name == "slopes-xi-eta") {
            const bool along = cable ? old % 2 == 1 : old == 3;
            const bool across = !cable && (old == 1 || old == 4 || old == 6);
            if (along) s = l / 2;
            if (across) s = h / 2;
        }
        out.vector_scale.push_back(s);
    }
    for (int i = 0; i < 2 * n; ++i) {
        const bool x_then_y = name == "x-then-y";
        const int a = x_then_y ? i % n : i / 2, c = x_then_y ? i / n : i % 2;
        out.place.push_back(2 * out.vectors[a] + c);
        out.scale.push_back(out.vector_scale[a]);
    }
    return out;
}

template <class T> Vec<T> read_coordinates(const Json& state, const char* key, bool cable, T l, T h) {
    const Vec<T> raw = numbers<T>(state, key, cable ? 8 : 14);
    const Layout<T> there = layout<T>(options.convention_in, cable, l, h);
    Vec<T> out(raw.size());
    for (size_t i = 0; i < raw.size(); ++i) out[there.place[i]] = raw[i] / there.scale[i];
    return out;
}

template <class T> State<T> read_state(const Json& j, bool cable) {
    State<T> s;
    s.l = scalar<T>(j, "l"), s.h = scalar<T>(j, "h"), s.w = scalar<T>(j, "w");
    if (!(s.l > 0) || !(s.h > 0) || !(s.w > 0)) throw runtime_error("l, h and w have to be over 0");
    s.E = scalar<T>(j, "E"), s.nu = scalar<T>(j, "nu"), s.rho = scalar<T>(j, "rho");
    if (!(s.E > 0)) throw runtime_error("E has to be over 0");
    if (!(s.nu > -1) || !(2 * s.nu < 1)) throw runtime_error("nu has to be between -1 and 1/2");
    if (!(s.rho > 0)) throw runtime_error("rho has to be over 0");
    s.alpha = scalar<T>(j, "alpha"), s.dT = scalar<T>(j, "dT");
    if (!(1 + 2 * s.alpha * s.dT > 0)) throw runtime_error("1 + 2 alpha dT has to be over 0");
    s.model = j.at("model").words;
    if (s.model != "none" && s.model != "1d" && s.model != "2d") throw runtime_error("model: none, 1d or 2d");
    s.theta = scalar<T>(j, "theta");
    if (options.convention_in == "degrees") s.theta *= std::acos(T(-1)) / 180;
    s.e0 = read_coordinates<T>(j, "e0", cable, s.l, s.h);
    s.e = read_coordinates<T>(j, "e", cable, s.l, s.h);
    s.edot = read_coordinates<T>(j, "edot", cable, s.l, s.h);
    s.gravity = j.find("gravity") ? numbers<T>(j, "gravity", 2) : Vec<T>{T(0), T(0)};
    const Json& points = j.at("points");
    if (points.items.empty()) throw runtime_error("points: one at least");
    for (const Json& p : points.items) {
        if (p.items.size() != 2) throw runtime_error("points: each [x, y]");
        const T x = static_cast<T>(p.items[0].value), y = static_cast<T>(p.items[1].value);
        if (x < 0 || x > s.l || 2 * std::abs(y) > s.h) throw runtime_error("a point is outside of the element");
        s.points.push_back({x, y});
    }
    // e0 has to be the straight element of length l at the inclination theta.
    const T c = std::cos(s.theta), sn = std::sin(s.theta);
    for (int i = 0; i < 2; ++i) {
        const T t = i == 0 ? c : sn, n = i == 0 ? -sn : c, r = s.e0[i];
        const Vec<T> straight = cable ? Vec<T>{r, t, r + s.l * t, t}
                                      : Vec<T>{r, n, r + s.l * t / 2, t, n, r + s.l * t, n};
        for (size_t a = 0; a < straight.size(); ++a)
            if (!(std::abs(s.e0[2 * a + i] - straight[a]) < T(1e-3) * (1 + s.l)))
                throw runtime_error("e0 has to be straight, unstretched, l long and inclined by theta");
    }
    return s;
}

// What a program with memory keeps from earlier questions.
template <class T> struct Memory {
    int questions = 0;
    bool has_mass = false, has_heat = false, has_points = false, has_start = false, has_lame = false;
    std::map<T, array<T, 2>> rotation; // by length
    Matrix<T> mass{14, 14};
    Vec<T> force = Vec<T>(14, T(0)), start;
    T heat = 0, length = 0, E = 0, nu = 0;
};

// ------------------------------------------------------------------------------------------------- the paper's beam

template <class T> class Beam {
  public:
    Beam(const State<T>& state, const Given<T>& given_values, Memory<T>& kept)
        : s(state), given(given_values), memory(kept) {
        if (options.memory == "start-of-first-state") {
            if (!memory.has_start) memory.start = s.e0, memory.has_start = true;
            s.e0 = memory.start;
        }
    }

    using Answer = std::function<Tensor<T>(Beam&)>;
    static const vector<pair<string, Answer>>& answers() {
        static const vector<pair<string, Answer>> table = make_answers();
        return table;
    }

  private:
    State<T> s;
    const Given<T>& given;
    Memory<T>& memory;

    // Part of a value that came with the question: that of point p, or the whole for p = -1.
    bool take(const char* name, int p, int length, T* out) const {
        const auto found = given.find(name);
        if (found == given.end()) return false;
        const size_t from = static_cast<size_t>(p < 0 ? 0 : p * length);
        if (found->second.size() < from + static_cast<size_t>(length)) throw runtime_error(string("given: ") + name);
        for (int i = 0; i < length; ++i) out[i] = found->second[from + static_cast<size_t>(i)];
        return true;
    }

    // Calculates a quantity at each of the state's points.
    Tensor<T> per_point(const vector<int>& shape, const std::function<Vec<T>(int)>& at) const {
        Tensor<T> out;
        out.shape = {static_cast<int>(s.points.size())};
        out.shape.insert(out.shape.end(), shape.begin(), shape.end());
        for (int p = 0; p < out.shape[0]; ++p)
            for (T number : at(p)) out.data.push_back(number);
        return out;
    }

    // --- (A.1) to (A.5): the field as a polynomial

    array<array<T, 2>, 7> nodes() const {
        array<array<T, 2>, 7> out;
        if (take("4.nodes", -1, 14, &out[0][0])) return out;
        for (int a = 0; a < 7; ++a)
            for (int c = 0; c < 2; ++c) {
                int place = 2 * a + c;
                if (m("4-all-x-first")) place = a + 7 * c;
                out[a][c] = s.e[place];
            }
        if (m("4-j-before-slope")) std::swap(out[1], out[2]);
        if (m("4-x-and-y-slope")) std::swap(out[3], out[4]);
        return out;
    }

    array<array<T, 2>, 7> coefficients() const {
        array<array<T, 2>, 7> k;
        if (take("A.3.coefficients", -1, 14, &k[0][0])) return k;
        const auto n = nodes();
        const T l = s.l;
        for (int c = 0; c < 2; ++c) {
            const T ri = n[0][c], yi = n[1][c], rj = n[2][c], xj = n[3][c], yj = n[4][c], rk = n[5][c], yk = n[6][c];
            k[0][c] = ri;
            k[1][c] = -(5 * ri - 4 * rj - rk + 2 * l * xj) / l;
            if (m("A3-printed")) k[1][c] = -(5 * ri - 4 * rj + rk + 2 * l * xj) / l;
            k[2][c] = yi;
            k[3][c] = -(3 * yi - 4 * yj + yk) / l;
            k[4][c] = (8 * ri - 4 * rj - 4 * rk + 6 * l * xj) / (l * l);
            if (m("A3-a4-over-l")) k[4][c] = (8 * ri - 4 * rj - 4 * rk + 6 * l * xj) / l;
            k[5][c] = -(4 * ri - 4 * rk + 4 * l * xj) / (l * l * l);
            k[6][c] = (2 * yi - 4 * yj + 2 * yk) / (l * l);
            if (m("A3-a6-sign")) k[6][c] = (2 * yi - 4 * yj - 2 * yk) / (l * l);
        }
        return k;
    }

    // Values of the polynomial (A.1) at a place: position, derivative in x, derivative in y.
    array<array<T, 2>, 3> polynomial(T x, T y) const {
        const auto k = coefficients();
        array<array<T, 2>, 3> out;
        for (int c = 0; c < 2; ++c) {
            out[0][c] = k[0][c] + k[1][c] * x + k[2][c] * y + k[3][c] * x * y + k[4][c] * x * x + k[5][c] * x * x * x +
                        k[6][c] * x * x * y;
            out[1][c] = k[1][c] + k[3][c] * y + 2 * k[4][c] * x + 3 * k[5][c] * x * x + 2 * k[6][c] * x * y;
            if (m("A1-rx-no-two"))
                out[1][c] = k[1][c] + k[3][c] * y + k[4][c] * x + 3 * k[5][c] * x * x + 2 * k[6][c] * x * y;
            out[2][c] = k[2][c] + k[3][c] * x + k[6][c] * x * x;
            if (m("A1-ry-no-square")) out[2][c] = k[2][c] + k[3][c] * x;
        }
        return out;
    }

    Vec<T> nodal_conditions() const {
        const T l = s.l;
        T middle = l / 2;
        if (m("A2-slope-at-end")) middle = l;
        const auto i = polynomial(T(0), T(0)), j = polynomial(l / 2, T(0)), k = polynomial(l, T(0));
        const auto slope = polynomial(middle, T(0));
        return {i[0][0], i[0][1], i[2][0], i[2][1], j[0][0], j[0][1], slope[1][0], slope[1][1],
                j[2][0], j[2][1], k[0][0], k[0][1], k[2][0], k[2][1]};
    }

    // --- (1) to (3): shape functions

    struct Shapes {
        T N[7], x[7], y[7];
    };

    // S_i is a polynomial of a = x/l, times y for the slopes r_y, times l for the slope r_x.
    Shapes shapes(T x, T y, int p) const {
        static const int powers[7][4] = {{1, -5, 8, -4}, {1, -3, 2, 0}, {0, 4, -4, 0}, {0, -2, 6, -4},
                                         {0, 4, -4, 0},  {0, 1, -4, 4}, {0, -1, 2, 0}};
        static const char factor[] = "1y1ly1y";
        const T l = s.l;
        T a = x / l;
        if (m("3-origin-in-middle")) a = x / l + T(1) / T(2);
        if (m("3-float-ratio")) a = static_cast<T>(static_cast<float>(x) / static_cast<float>(l));
        Shapes out;
        for (int i = 0; i < 7; ++i) {
            int q = i;
            if (m("3-s3-s6-exchanged")) q = i == 2 ? 5 : i == 5 ? 2 : i;
            int k[4] = {powers[q][0], powers[q][1], powers[q][2], powers[q][3]};
            if (m("3-s1-six") && i == 0) k[2] = 6;
            if (m("3-s6-sign") && i == 5) k[2] = 4;
            if (m("3-s2-square-lost") && i == 1) k[1] = -1, k[2] = 0;
            if (m("3-s7-factor") && i == 6) k[2] = 4;
            T scale = factor[i] == 'y' ? y : factor[i] == 'l' ? l : T(1);
            T across = factor[i] == 'y' ? T(1) : T(0);
            if (m("3-s4-no-l") && i == 3) scale = 1;
            if (m("3-slopes-no-l") && factor[i] == 'y') scale = y / l, across = 1 / l;
            const T value = k[0] + a * (k[1] + a * (k[2] + a * k[3]));
            const T slope = k[1] + a * (2 * k[2] + a * (3 * k[3]));
            out.N[i] = scale * value;
            out.x[i] = scale * slope / l;
            if (m("3-no-chain-rule")) out.x[i] = scale * slope;
            if (m("3-s4-product-rule") && i == 3) out.x[i] = -2 + 6 * a - 4 * a * a;
            if (m("3-s5-copied") && i == 4) out.x[i] = slope / l;
            if (m("3-s1x-power") && i == 0) out.x[i] = (-5 + 16 * a - 4 * a * a) / l;
            out.y[i] = across * value;
            if (m("3-s2y-keeps-y") && i == 1) out.y[i] = scale * value;
            if (m("3-sy-loop-short") && i == 6) out.y[i] = 0;
            if (m("3-sy-of-sx") && i == 4) out.y[i] = 4 - 8 * a;
        }
        if (p >= 0) {
            take("3.S", p, 7, out.N);
            take("3.S_x", p, 7, out.x);
            take("3.S_y", p, 7, out.y);
        }
        return out;
    }
    Shapes shapes(int p) const { return shapes(s.points[p][0], s.points[p][1], p); }

    Matrix<T> shape_matrix(int p) const {
        Matrix<T> S(2, 14);
        if (take("2.S", p, 28, S.data.data())) return S;
        const Shapes f = shapes(p);
        for (int a = 0; a < 7; ++a)
            for (int c = 0; c < 2; ++c) {
                if (m("2-blocks"))
                    S(c, a + 7 * c) = f.N[a];
                else if (m("2-second-row") && c == 1)
                    S(c, 2 * a) = f.N[a];
                else
                    S(c, 2 * a + c) = f.N[a];
            }
        return S;
    }

    Vec<T> position(int p) const {
        Vec<T> r = times(shape_matrix(p), m("1-of-start") ? s.e0 : s.e);
        if (m("1-x-twice")) r[1] = r[0];
        return r;
    }

    Vec<T> position_by_vectors(int p) const {
        const Shapes f = shapes(p);
        const auto n = nodes();
        Vec<T> r(2, T(0));
        for (int a = 0; a < 7; ++a)
            for (int c = 0; c < 2; ++c) {
                T part = f.N[a] * n[a][c];
                if (m("A4-rj-slope-no-l") && a == 4) part /= s.l;
                if (m("A4-last-left-out") && a == 6) part = 0;
                r[c] += part;
            }
        return r;
    }

    // --- (5) to (7): inertia

    Vec<T> velocity(int p) const {
        Vec<T> v = times(shape_matrix(m("5-first-point") ? 0 : p), m("5-of-e") ? s.e : s.edot);
        if (m("5-plus-position")) v[0] += position(p)[0];
        return v;
    }

    struct Place {
        T x, y, volume;
    };

    // Gauss points of the volume.
    vector<Place> volume(int along, int across) const {
        T l = s.l, h = s.h, w = s.w;
        if (m("7-h-w-exchanged")) std::swap(h, w);
        if (options.memory == "points-of-first-length") {
            if (!memory.has_points) memory.length = l, memory.has_points = true;
            l = memory.length;
        }
        vector<Place> out;
        for (const auto& px : gauss<T>(along))
            for (const auto& py : gauss<T>(across))
                out.push_back({l * (1 + px.first) / 2, h * py.first / 2, px.second * py.second * l * h * w / 4});
        return out;
    }

    Matrix<T> mass() {
        Matrix<T> M(14, 14);
        if (take("7.M", -1, 196, M.data.data())) return M;
        if (options.memory == "mass-of-first-state" && memory.has_mass) return memory.mass;
        T rho = s.rho;
        if (m("7-no-width")) rho /= s.w;
        if (m("7-jacobian-l")) rho *= 2;
        if (m("7-weight")) rho *= T(98) / T(10);
        if (m("7-length-now")) rho *= std::hypot(s.e[10] - s.e[0], s.e[11] - s.e[1]) / s.l;
        for (const Place& q : volume(m("7-three-points") ? 3 : 4, m("7-no-rotary") ? 1 : 2)) {
            const Shapes f = shapes(q.x, q.y, -1);
            for (int a = 0; a < 7; ++a)
                for (int b = 0; b < 7; ++b) {
                    if (m("7-upper-only") && b < a) continue;
                    for (int c = 0; c < 2; ++c) M(2 * a + c, 2 * b + c) += rho * f.N[a] * f.N[b] * q.volume;
                    if (m("7-all-components")) {
                        M(2 * a, 2 * b + 1) += rho * f.N[a] * f.N[b] * q.volume;
                        M(2 * a + 1, 2 * b) += rho * f.N[a] * f.N[b] * q.volume;
                    }
                }
        }
        if (m("7-lumped"))
            for (int i = 0; i < 14; ++i) {
                T sum = 0;
                for (int j = 0; j < 14; ++j) sum += M(i, j), M(i, j) = 0;
                M(i, i) = sum;
            }
        if (options.memory == "mass-of-first-state") memory.mass = M, memory.has_mass = true;
        return M;
    }

    T kinetic_energy() {
        Matrix<T> M = mass();
        if (m("6-diagonal"))
            for (int i = 0; i < 14; ++i)
                for (int j = 0; j < 14; ++j)
                    if (i != j) M(i, j) = 0;
        T energy = dot(s.edot, times(M, s.edot)) / 2;
        if (m("6-no-half")) energy *= 2;
        if (m("6-x-only")) {
            Vec<T> v = s.edot;
            for (int a = 0; a < 7; ++a) v[2 * a + 1] = 0;
            energy = dot(v, times(M, v)) / 2;
        }
        return energy;
    }

    // --- (8): heat

    // Thermal strain (11, 22, 12) in global axes; along the rod's own axes with `own`.
    array<T, 3> thermal_strain(bool own) {
        array<T, 3> out;
        if (!own && take("8.epsilon_T", -1, 3, out.data())) return out;
        T dT = s.dT;
        if (m("8-kelvin")) dT += T(273.15);
        if (m("8-absolute")) dT = std::abs(dT);
        T a = s.alpha * dT;
        if (options.memory == "heat-of-previous") {
            const T now = a;
            if (memory.has_heat) a = memory.heat;
            memory.heat = now, memory.has_heat = true;
        }
        if (m("8-twice-alpha")) a *= 2;
        if (m("8-stretch-squared")) a = a + a * a / 2;
        string model = s.model;
        if (m("8-model-ignored")) model = "2d";
        if (m("8-2d-as-1d") && model == "2d") model = "1d";
        if (model == "none") return {T(0), T(0), T(0)};
        const T c = own ? T(1) : std::cos(s.theta), sn = own ? T(0) : std::sin(s.theta);
        if (model == "2d") {
            if (m("8-shear")) return {a, a, a};
            if (m("8-plane-strain")) return {a * (1 + s.nu), a * (1 + s.nu), T(0)};
            if (m("8-across-only")) return {T(0), a, T(0)};
            return {a, a, T(0)};
        }
        if (m("8-along-x")) return {a, T(0), T(0)};
        if (m("8-1d-as-vector")) return {a * c, a * sn, T(0)};
        if (m("8-1d-shear-sign")) return {a * c * c, a * sn * sn, -a * sn * c};
        if (m("8-1d-shear-twice")) return {a * c * c, a * sn * sn, 2 * a * sn * c};
        if (m("8-1d-no-shear")) return {a * c * c, a * sn * sn, T(0)};
        if (m("8-1d-sin-cos")) return {a * sn * sn, a * c * c, a * sn * c};
        return {a * c * c, a * sn * sn, a * sn * c};
    }

    // --- (9) to (14): strain

    using Two = array<array<T, 2>, 2>;

    // Derivatives of the field with nodal coordinates u by x and y.
    Two gradient(const Shapes& f, const Vec<T>& u) const {
        Two F{};
        for (int a = 0; a < 7; ++a)
            for (int c = 0; c < 2; ++c) {
                F[c][0] += f.x[a] * u[2 * a + c];
                F[c][1] += f.y[a] * u[2 * a + c];
            }
        return F;
    }

    Two initial_gradient(const Shapes& f, int p) const {
        Two J0;
        if (p >= 0 && take("9.J_0", p, 4, &J0[0][0])) return J0;
        J0 = gradient(f, m("9-J0-of-e") ? s.e : s.e0);
        if (m("9-J0-rows")) std::swap(J0[0][1], J0[1][0]);
        return J0;
    }

    // Whether the energy is calculated in the rod's own axes, as if theta were 0.
    static bool own_axes() { return m("E3-own-axes"); }

    Two initial_inverse(const Shapes& f, int p) const {
        if (p < 0 && own_axes()) return {{{T(1), T(0)}, {T(0), T(1)}}};
        const Two a = initial_gradient(f, p);
        const T det = a[0][0] * a[1][1] - a[0][1] * a[1][0];
        if (m("9-not-inverted")) return a;
        if (m("9-no-J0")) return {{{T(1), T(0)}, {T(0), T(1)}}};
        if (m("9-inverse-no-signs")) return {{{a[1][1] / det, a[0][1] / det}, {a[1][0] / det, a[0][0] / det}}};
        if (m("9-inverse-one-sign")) return {{{a[1][1] / det, -a[0][1] / det}, {a[1][0] / det, a[0][0] / det}}};
        return {{{a[1][1] / det, -a[0][1] / det}, {-a[1][0] / det, a[0][0] / det}}};
    }

    // J (9) and the derivatives of the shape functions by global initial coordinates.
    struct Kinematics {
        Two J;
        T G[7][2];
    };

    Kinematics kinematics(const Shapes& f, int p) const {
        const Two F = gradient(f, s.e), inverse = initial_inverse(f, p);
        Kinematics k{};
        for (int a = 0; a < 7; ++a)
            for (int j = 0; j < 2; ++j) k.G[a][j] = f.x[a] * inverse[0][j] + f.y[a] * inverse[1][j];
        for (int c = 0; c < 2; ++c)
            for (int j = 0; j < 2; ++j) {
                for (int q = 0; q < 2; ++q) k.J[c][j] += F[c][q] * inverse[q][j];
            }
        if (m("9-order")) {
            Two other{};
            for (int c = 0; c < 2; ++c)
                for (int j = 0; j < 2; ++j)
                    for (int q = 0; q < 2; ++q) other[c][j] += inverse[c][q] * F[q][j];
            k.J = other;
        }
        if (m("9-transposed")) std::swap(k.J[0][1], k.J[1][0]);
        if (p >= 0) take("9.J", p, 4, &k.J[0][0]);
        return k;
    }

    Two green_lagrange(const Kinematics& k, int p) const {
        Two out{};
        if (p >= 0 && take("10.epsilon_m", p, 4, &out[0][0])) return out;
        for (int i = 0; i < 2; ++i)
            for (int j = 0; j < 2; ++j) {
                T sum = 0;
                for (int c = 0; c < 2; ++c) sum += m("10-J-Jt") ? k.J[i][c] * k.J[j][c] : k.J[c][i] * k.J[c][j];
                const T one = i == j ? T(1) : T(0);
                out[i][j] = (sum - one) / 2;
                if (m("10-no-half")) out[i][j] = sum - one;
                if (m("10-linear")) out[i][j] = (k.J[i][j] + k.J[j][i]) / 2 - one;
                if (m("10-one-everywhere")) out[i][j] = (sum - 1) / 2;
                if (m("10-one-once") && i == 1) out[i][j] = sum / 2;
                if (m("10-half-of-J")) out[i][j] = sum / 2 - one;
            }
        return out;
    }

    // Angle of (11).
    array<T, 2> cosine_and_sine(int p) const {
        if (p < 0 && own_axes()) return {T(1), T(0)};
        T angle = s.theta;
        if (m("11-minus-theta")) angle = -angle;
        if (m("11-degrees")) angle *= std::acos(T(-1)) / 180;
        if (m("11-theta-now")) angle = std::atan2(s.e[11] - s.e[1], s.e[10] - s.e[0]);
        array<T, 2> out = {std::cos(angle), std::sin(angle)};
        if (options.memory == "rotation-by-length") {
            const auto known = memory.rotation.emplace(s.l, out);
            out = known.first->second;
        }
        return out;
    }

    // Coefficients of the products of derivatives in S_a, S_b, S_c (11): by x x, x y, y x, y y.
    array<T, 4> metric_coefficients(int which, int p) const {
        const auto cs = cosine_and_sine(p);
        const T c = cs[0], n = cs[1];
        if (which == 0) {
            if (m("11-sa-sin-cos")) return {n * n, -n * c, -n * c, c * c};
            if (m("11-sa-cross-once")) return {c * c, -n * c, T(0), n * n};
            if (m("11-sa-cos-not-squared")) return {c, -n * c, -n * c, n * n};
            return {c * c, -n * c, -n * c, n * n};
        }
        if (which == 1) {
            if (m("11-sb-cross-sign")) return {n * n, -n * c, -n * c, c * c};
            if (m("11-sb-no-yy")) return {n * n, n * c, n * c, T(0)};
            return {n * n, n * c, n * c, c * c};
        }
        if (m("11-sc-no-yy")) return {n * c, c * c, -n * n, T(0)};
        if (m("11-sc-squares-exchanged")) return {n * c, n * n, -c * c, -n * c};
        if (m("11-sc-sign")) return {n * c, c * c, n * n, -n * c};
        return {n * c, c * c, -n * n, -n * c};
    }

    // S_a, S_b or S_c (11), for which = 0, 1, 2.
    Matrix<T> metric(const Shapes& f, int which, int p) const {
        static const char* const names[] = {"11.S_a", "11.S_b", "11.S_c"};
        Matrix<T> S(14, 14);
        if (p >= 0 && take(names[which], p, 196, S.data.data())) return S;
        const auto k = metric_coefficients(which, p);
        for (int a = 0; a < 7; ++a)
            for (int b = 0; b < 7; ++b) {
                const T entry = k[0] * f.x[a] * f.x[b] + k[1] * f.x[a] * f.y[b] + k[2] * f.y[a] * f.x[b] +
                                k[3] * f.y[a] * f.y[b];
                for (int c = 0; c < 2; ++c) {
                    if (m("11-first-row-only") && c == 1) continue;
                    S(2 * a + c, 2 * b + c) = entry;
                }
            }
        if (which == 2 && m("11-sc-plus-transpose")) {
            const Matrix<T> t = transposed(S);
            for (size_t i = 0; i < S.data.size(); ++i) S.data[i] += t.data[i];
        }
        return S;
    }

    // e^T S e of the three matrices; J^T J without them.
    T form(const Matrix<T>& S) const { return dot(s.e, times(S, s.e)); }

    T strain_by_metric(const Shapes& f, int which, int p) const {
        static const char* const names[] = {"13.epsilon_1", "13.epsilon_2", "13.epsilon_3"};
        T given_value;
        if (p >= 0 && take(names[which], p, 1, &given_value)) return given_value;
        const T value = form(metric(f, which == 1 && m("13-second-copied") ? 0 : which, p));
        if (which == 0 && m("13-half-of-first")) return value / 2 - 1;
        if (which == 2) {
            if (m("13-shear-no-half")) return value;
            if (m("13-shear-one")) return (value - 1) / 2;
            return value / 2;
        }
        return (value - 1) / 2;
    }

    static bool by_paper() { return options.route == "paper"; }

    // Strain (12) as (11, 22, 12): through (13) or through (10).
    array<T, 3> strain(const Shapes& f, int p) const {
        array<T, 3> out;
        if (p >= 0 && take("12.epsilon_f", p, 3, out.data())) return out;
        if (by_paper())
            out = {strain_by_metric(f, 0, p), strain_by_metric(f, 1, p), strain_by_metric(f, 2, p)};
        else {
            const Two e = green_lagrange(kinematics(f, p), p);
            out = {e[0][0], e[1][1], e[0][1]};
        }
        if (m("12-shear-twice")) out[2] *= 2;
        if (m("12-order")) std::swap(out[1], out[2]);
        if (m("12-shear-minus")) out[2] = -out[2];
        return out;
    }

    array<T, 3> elastic_strain(const Shapes& f, int p) {
        array<T, 3> out;
        if (p >= 0 && take("14.epsilon", p, 3, out.data())) return out;
        const auto whole = strain(f, p);
        auto heat = thermal_strain(p < 0 && own_axes());
        if (m("14-twice")) for (T& part : heat) part *= 2;
        if (m("14-first-only")) heat[1] = heat[2] = 0;
        if (m("14-no-shear")) heat[2] = 0;
        for (int i = 0; i < 3; ++i) out[i] = m("14-plus") ? whole[i] + heat[i] : whole[i] - heat[i];
        return out;
    }

    // --- (15) to (17): stress

    T poisson() const {
        if (m("17-nu-steel")) return T(3) / T(10);
        if (m("17-nu-left-out")) return T(0);
        if (m("17-nu-absolute")) return std::abs(s.nu);
        if (options.memory == "material-of-first-state") return memory.nu;
        return s.nu;
    }
    T modulus() {
        if (options.memory != "material-of-first-state") return s.E;
        if (!memory.has_lame) memory.E = s.E, memory.nu = s.nu, memory.has_lame = true;
        return memory.E;
    }
    T lame() {
        T value;
        if (take("17.lambda", -1, 1, &value)) return value;
        const T E = modulus(), nu = poisson();
        if (m("17-lambda-precedence")) return E * nu / (1 + nu) * (1 - 2 * nu);
        if (m("17-lambda-plane-stress")) return E * nu / (1 - nu * nu);
        if (m("17-lambda-no-nu")) return E / ((1 + nu) * (1 - 2 * nu));
        return E * nu / ((1 + nu) * (1 - 2 * nu));
    }
    T shear_modulus() {
        T value;
        if (take("17.mu", -1, 1, &value)) return value;
        const T E = modulus(), nu = poisson();
        if (m("17-mu-no-two")) return E / (1 + nu);
        if (m("17-mu-precedence")) return E / 2 * (1 + nu);
        if (m("17-mu-minus")) return E / (2 * (1 - nu));
        if (m("17-mu-half-E")) return E / 2;
        return E / (2 * (1 + nu));
    }

    Matrix<T> elasticity() {
        Matrix<T> D(3, 3);
        if (take("16.D", -1, 9, D.data.data())) return D;
        const T la = lame(), mu = shear_modulus();
        D(0, 0) = D(1, 1) = la + 2 * mu;
        D(0, 1) = D(1, 0) = la;
        D(2, 2) = 2 * mu;
        if (m("16-shear-mu")) D(2, 2) = mu;
        if (m("16-shear-four-mu")) D(2, 2) = 4 * mu;
        if (m("16-upper-only")) D(1, 0) = 0;
        if (m("16-diagonal-mu")) D(0, 0) = D(1, 1) = la + mu;
        if (m("16-no-lambda")) D(0, 0) = D(1, 1) = 2 * mu;
        if (m("16-no-coupling")) D(0, 1) = D(1, 0) = 0;
        if (m("16-coupling-mu")) D(0, 1) = D(1, 0) = mu;
        if (m("16-plane-stress")) {
            const T k = s.E / (1 - s.nu * s.nu);
            D(0, 0) = D(1, 1) = k;
            D(0, 1) = D(1, 0) = k * s.nu;
        }
        return D;
    }

    array<T, 3> stress(const Shapes& f, int p) {
        array<T, 3> out{};
        if (p >= 0 && take("15.sigma", p, 3, out.data())) return out;
        const auto e = m("15-no-heat") ? strain(f, p) : elastic_strain(f, p);
        const Matrix<T> D = elasticity();
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) out[i] += D(i, j) * e[j];
        if (m("15-shear-half")) out[2] /= 2;
        if (m("15-overwritten")) out[1] = D(1, 1) * e[1];
        return out;
    }

    // --- (18): energy

    vector<Place> stiffness_places() const {
        int along = 5, across = 3;
        if (m("18-four-along")) along = 4;
        if (m("18-two-along")) along = 2;
        if (m("18-three-along")) along = 3;
        if (m("18-two-across")) across = 2;
        if (m("18-axis-only")) across = 1;
        auto out = volume(along, across);
        for (Place& q : out) {
            if (m("18-centred-points")) q.x -= s.l / 2;
            if (m("18-unscaled-y")) q.y *= 2;
            if (m("18-no-width")) q.volume /= s.w;
            if (m("18-jacobian-h")) q.volume *= 2;
        }
        return out;
    }

    // How often the shear counts in the contraction of strain and stress.
    static T shear_count() { return m("E3-energy") || m("E3-own-axes") ? T(1) : T(2); }

    T energy() {
        T sum = 0;
        for (const Place& q : stiffness_places()) {
            const Shapes f = shapes(q.x, q.y, -1);
            const auto e = m("18-strain-with-heat") ? strain(f, -1) : elastic_strain(f, -1);
            const auto o = stress(f, -1);
            sum += (e[0] * o[0] + e[1] * o[1] + shear_count() * e[2] * o[2]) * q.volume;
        }
        if (m("18-integer-half")) return (1 / 2) * sum;
        if (m("18-no-half")) return sum;
        return sum / 2;
    }

    // --- (19) to (21): forces

    // Derivative of the strain (11, 22, 12) by coordinate c of nodal vector a.
    array<T, 3> strain_derivative(const Kinematics& k, int a, int c) const {
        if (m("19-at-start")) {
            const T d0 = c == 0 ? T(1) : T(0), d1 = c == 1 ? T(1) : T(0);
            return {k.G[a][0] * d0, k.G[a][1] * d1, (k.G[a][0] * d1 + k.G[a][1] * d0) / 2};
        }
        array<T, 3> out = {k.G[a][0] * k.J[c][0], k.G[a][1] * k.J[c][1],
                           (k.G[a][0] * k.J[c][1] + k.G[a][1] * k.J[c][0]) / 2};
        if (m("19-shear-half-missing")) out[2] = k.G[a][0] * k.J[c][1] / 2;
        if (m("19-shear-engineering")) out[2] *= 2;
        if (m("19-J-transposed")) out[0] = k.G[a][0] * k.J[0][c], out[1] = k.G[a][1] * k.J[1][c];
        return out;
    }

    Vec<T> force_by_stress() {
        Vec<T> Q(14, T(0));
        for (const Place& q : stiffness_places()) {
            const Shapes f = shapes(q.x, q.y, -1);
            const Kinematics k = kinematics(f, -1);
            auto o = stress(f, -1);
            if (m("19-no-heat")) {
                const auto e = strain(f, -1);
                const Matrix<T> D = elasticity();
                for (int i = 0; i < 3; ++i) o[i] = D(i, 0) * e[0] + D(i, 1) * e[1] + D(i, 2) * e[2];
            }
            if (m("19-no-shear")) o[2] = 0;
            for (int a = 0; a < 7; ++a)
                for (int c = 0; c < 2; ++c) {
                    const auto d = strain_derivative(k, a, c);
                    Q[2 * a + c] += (o[0] * d[0] + o[1] * d[1] + shear_count() * o[2] * d[2]) * q.volume;
                }
        }
        return Q;
    }

    Matrix<T> symmetric_sum(const Shapes& f, int which, int p) const {
        static const char* const names[] = {"21.S_a1", "21.S_b1", "21.S_c1"};
        Matrix<T> S(14, 14);
        if (p >= 0 && take(names[which], p, 196, S.data.data())) return S;
        S = metric(f, which, p);
        const Matrix<T> t = transposed(S);
        for (size_t i = 0; i < S.data.size(); ++i) {
            if (which == 2 && m("21-sc1-twice"))
                S.data[i] *= 2;
            else if (m("21-not-added"))
                S.data[i] = t.data[i];
            else if (which == 1 && m("21-sb1-minus"))
                S.data[i] -= t.data[i];
            else
                S.data[i] += t.data[i];
        }
        return S;
    }

    // K_1, K_2 or K_3 (21), for which = 1, 2, 3.
    Matrix<T> stiffness_part(int which) {
        static const char* const names[] = {"21.K_1", "21.K_2", "21.K_3"};
        Matrix<T> K(14, 14);
        if (take(names[which - 1], -1, 196, K.data.data())) return K;
        for (const Place& q : stiffness_places()) {
            const Shapes f = shapes(q.x, q.y, -1);
            const auto heat = thermal_strain(own_axes());
            T a = form(metric(f, 0, -1)) - 1 - 2 * heat[0];
            T b = form(metric(f, 1, -1)) - 1 - 2 * heat[1];
            T c = form(metric(f, 2, -1)) - 2 * heat[2];
            if (m("21-heat-once")) a += heat[0], b += heat[1], c += heat[2];
            if (m("21-heat-plus")) a += 4 * heat[0], b += 4 * heat[1], c += 4 * heat[2];
            if (m("21-k2-no-heat") && which == 2) a += 2 * heat[0], b += 2 * heat[1];
            if (m("21-k1-heat-on-a-only") && which == 1) b += 2 * heat[1];
            if (m("21-k3-no-heat")) c += 2 * heat[2];
            if (m("21-k3-printed")) c = form(metric(f, 2, -1)) - 1;
            if (m("21-1d-heat-even") && s.model == "1d") {
                const T even = s.alpha * s.dT;
                a += 2 * heat[0] - 2 * even, b += 2 * heat[1] - 2 * even, c += 2 * heat[2];
            }
            if (m("21-no-one")) b += 1;
            T quarter = q.volume / 4;
            if (m("21-k3-half") && which == 3) quarter *= 2;
            if (m("21-no-quarter")) quarter *= 4;
            if (which == 3) {
                const Matrix<T> C = symmetric_sum(f, 2, -1);
                for (size_t i = 0; i < K.data.size(); ++i) K.data[i] += quarter * C.data[i] * c;
                continue;
            }
            const Matrix<T> A = symmetric_sum(f, 0, -1), B = symmetric_sum(f, 1, -1);
            const bool crossed = which == 2 && !m("21-k2-copied");
            for (size_t i = 0; i < K.data.size(); ++i) {
                T part = crossed ? A.data[i] * b + B.data[i] * a : A.data[i] * a + B.data[i] * b;
                if (m("21-k2-first-term") && which == 2) part = A.data[i] * b;
                K.data[i] += quarter * part;
            }
        }
        return K;
    }

    Matrix<T> stiffness() {
        Matrix<T> K(14, 14);
        if (take("20.K", -1, 196, K.data.data())) return K;
        const T la = lame(), mu = shear_modulus();
        const Matrix<T> K1 = stiffness_part(1), K2 = stiffness_part(2), K3 = stiffness_part(3);
        T first = la + 2 * mu, second = la, third = 2 * shear_count() * mu;
        if (m("20-printed")) third = 2 * mu;
        if (m("20-exchanged")) std::swap(first, second);
        if (m("20-one-mu")) first = la + mu;
        if (m("20-minus")) second = -la;
        if (m("20-no-k3")) third = 0;
        if (m("20-k2-mu")) second = mu;
        for (size_t i = 0; i < K.data.size(); ++i)
            K.data[i] = first * K1.data[i] + second * K2.data[i] + third * K3.data[i];
        return K;
    }

    Vec<T> force() {
        Vec<T> Q(14, T(0));
        if (take("19.Q_e", -1, 14, Q.data())) return Q;
        if (by_paper()) {
            const Matrix<T> K = stiffness();
            Q = times(K, s.e);
            if (m("19-displacement")) {
                Vec<T> u = s.e;
                for (int i = 0; i < 14; ++i) u[i] -= s.e0[i];
                Q = times(K, u);
            }
            if (m("19-K-of-start")) Q = times(K, s.e0);
        } else
            Q = force_by_stress();
        if (m("19-minus")) for (T& part : Q) part = -part;
        if (m("19-half")) for (T& part : Q) part /= 2;
        if (options.memory == "force-buffer") {
            for (int i = 0; i < 14; ++i) memory.force[i] += Q[i];
            Q = memory.force;
        }
        return Q;
    }

    // --- the tangent

    Matrix<T> tangent_by_stress() {
        Matrix<T> K(14, 14);
        const Matrix<T> D = elasticity();
        const T count[3] = {T(1), T(1), m("tangent-shear-once") ? T(1) : shear_count()};
        for (const Place& q : stiffness_places()) {
            const Shapes f = shapes(q.x, q.y, -1);
            const Kinematics k = kinematics(f, -1);
            auto o = stress(f, -1);
            if (m("tangent-heat-left-out")) {
                const auto e = strain(f, -1);
                for (int i = 0; i < 3; ++i) o[i] = D(i, 0) * e[0] + D(i, 1) * e[1] + D(i, 2) * e[2];
            }
            array<T, 3> B[14];
            for (int i = 0; i < 14; ++i) B[i] = strain_derivative(k, i / 2, i % 2);
            for (int i = 0; i < 14; ++i)
                for (int j = 0; j < 14; ++j) {
                    T material = 0;
                    for (int u = 0; u < 3; ++u)
                        for (int v = 0; v < 3; ++v) {
                            if (m("tangent-no-coupling") && u != v) continue;
                            material += count[u] * B[i][u] * D(u, v) * B[j][v];
                        }
                    T geometric = 0;
                    if (i % 2 == j % 2) {
                        const T* g = k.G[i / 2];
                        const T* h = k.G[j / 2];
                        geometric = o[0] * g[0] * h[0] + o[1] * g[1] * h[1] +
                                    shear_count() * o[2] * (g[0] * h[1] + g[1] * h[0]) / 2;
                        if (m("tangent-geometric-no-shear")) geometric = o[0] * g[0] * h[0] + o[1] * g[1] * h[1];
                    }
                    if (m("tangent-no-geometric")) geometric = 0;
                    if (m("tangent-geometric-sign")) geometric = -geometric;
                    K(i, j) += (material + geometric) * q.volume;
                }
        }
        return K;
    }

    // K and the derivatives of K_1, K_2, K_3 times e.
    Matrix<T> tangent_by_paper() {
        Matrix<T> K = stiffness();
        if (m("tangent-secant")) return K;
        const T la = lame(), mu = shear_modulus();
        const T first = la + 2 * mu, second = la, third = 2 * shear_count() * mu;
        for (const Place& q : stiffness_places()) {
            const Shapes f = shapes(q.x, q.y, -1);
            const Vec<T> a = times(symmetric_sum(f, 0, -1), s.e), b = times(symmetric_sum(f, 1, -1), s.e),
                         c = times(symmetric_sum(f, 2, -1), s.e);
            T quarter = q.volume / 4;
            if (m("tangent-half")) quarter *= 2;
            for (int i = 0; i < 14; ++i)
                for (int j = 0; j < 14; ++j) {
                    T part = first * (a[i] * a[j] + b[i] * b[j]) + second * (a[i] * b[j] + b[i] * a[j]) +
                             third * c[i] * c[j];
                    if (m("tangent-k2-one-term"))
                        part = first * (a[i] * a[j] + b[i] * b[j]) + second * a[i] * b[j] + third * c[i] * c[j];
                    K(i, j) += quarter * part;
                }
        }
        return K;
    }

    Matrix<T> tangent() {
        Matrix<T> K = by_paper() ? tangent_by_paper() : tangent_by_stress();
        if (m("tangent-upper-only"))
            for (int i = 0; i < 14; ++i)
                for (int j = 0; j < i; ++j) K(i, j) = 0;
        return K;
    }

    // --- weight and (22)

    Vec<T> weight() {
        Vec<T> Q(14, T(0));
        if (take("gravity.Q_w", -1, 14, Q.data())) return Q;
        T g[2] = {s.gravity[0], s.gravity[1]};
        if (m("gravity-y-only")) g[0] = 0;
        if (m("gravity-minus")) g[0] = -g[0], g[1] = -g[1];
        if (m("gravity-9.81") && g[1] == T(-9.8)) g[1] = T(-9.81);
        if (m("gravity-own-axes")) {
            const T c = std::cos(s.theta), n = std::sin(s.theta), x = g[0], y = g[1];
            g[0] = c * x + n * y, g[1] = -n * x + c * y;
        }
        T rho = s.rho;
        if (m("gravity-no-width")) rho /= s.w;
        for (const Place& q : volume(m("gravity-one-point") ? 1 : 4, 2)) {
            const Shapes f = shapes(q.x, q.y, -1);
            for (int a = 0; a < 7; ++a) {
                for (int c = 0; c < 2; ++c) Q[2 * a + c] += rho * f.N[a] * g[c] * q.volume;
            }
        }
        if (m("gravity-half-to-each-end")) {
            const T half = s.rho * s.l * s.h * s.w / 2;
            Q.assign(14, T(0));
            for (int c = 0; c < 2; ++c) Q[c] = Q[10 + c] = half * g[c];
        }
        if (m("gravity-nodes-exchanged"))
            for (int c = 0; c < 2; ++c) std::swap(Q[4 + c], Q[10 + c]);
        return Q;
    }

    Vec<T> acceleration() {
        Matrix<T> M = mass();
        const Vec<T> Qe = force(), Qw = weight();
        Vec<T> b(14);
        for (int i = 0; i < 14; ++i) {
            b[i] = Qw[i] - Qe[i];
            if (m("22-plus-force")) b[i] = Qw[i] + Qe[i];
            if (m("22-no-weight")) b[i] = -Qe[i];
            if (m("22-no-force")) b[i] = Qw[i];
        }
        if (m("22-diagonal")) {
            for (int i = 0; i < 14; ++i) b[i] /= M(i, i);
            return b;
        }
        if (m("22-not-solved")) return times(M, b);
        return solve(M, b);
    }

    Vec<T> residual() {
        const Vec<T> Ma = times(mass(), m("22-residual-of-e") ? s.e : s.edot), Qe = force(), Qw = weight();
        Vec<T> out(14);
        for (int i = 0; i < 14; ++i) {
            out[i] = Ma[i] + Qe[i] - Qw[i];
            if (m("22-residual-weight-sign")) out[i] = Ma[i] + Qe[i] + Qw[i];
            if (m("22-residual-no-inertia")) out[i] = Qe[i] - Qw[i];
        }
        return out;
    }

    // --- answers by name

    static Vec<T> pair_of(const array<T, 2>& a) { return {a[0], a[1]}; }
    static Vec<T> triple_of(const array<T, 3>& a) { return {a[0], a[1], a[2]}; }
    static Vec<T> two_by_two(const Two& a) { return {a[0][0], a[0][1], a[1][0], a[1][1]}; }
    static Tensor<T> seven_rows(const array<array<T, 2>, 7>& rows) {
        Tensor<T> out{{7, 2}, {}};
        for (const auto& row : rows) out.data.insert(out.data.end(), row.begin(), row.end());
        return out;
    }
    Tensor<T> of_polynomial(int which) const {
        return per_point({2}, [&](int p) { return pair_of(polynomial(s.points[p][0], s.points[p][1])[which]); });
    }
    Tensor<T> of_metric(int which) const {
        return per_point({14, 14}, [&](int p) { return metric(shapes(p), which, p).data; });
    }
    Tensor<T> of_symmetric_sum(int which) const {
        return per_point({14, 14}, [&](int p) { return symmetric_sum(shapes(p), which, p).data; });
    }
    // Component of the strain as (13) has it; by the stress route it is that of (12).
    Tensor<T> of_component(int which) const {
        return per_point({}, [&](int p) {
            const Shapes f = shapes(p);
            return Vec<T>{by_paper() ? strain_by_metric(f, which, p) : strain(f, p)[which]};
        });
    }

    static vector<pair<string, Answer>> make_answers() {
        using B = Beam&;
        return {
            {"A.1.r", [](B b) { return b.of_polynomial(0); }},
            {"A.1.r_x", [](B b) { return b.of_polynomial(1); }},
            {"A.1.r_y", [](B b) { return b.of_polynomial(2); }},
            {"A.2.e", [](B b) { return Tensor<T>{{14}, b.nodal_conditions()}; }},
            {"A.3.coefficients", [](B b) { return seven_rows(b.coefficients()); }},
            {"A.4.r", [](B b) { return b.per_point({2}, [&](int p) { return b.position_by_vectors(p); }); }},
            {"1.r", [](B b) { return b.per_point({2}, [&](int p) { return b.position(p); }); }},
            {"2.S", [](B b) { return b.per_point({2, 14}, [&](int p) { return b.shape_matrix(p).data; }); }},
            {"3.S", [](B b) {
                 return b.per_point({7}, [&](int p) { const Shapes f = b.shapes(p); return Vec<T>(f.N, f.N + 7); });
             }},
            {"3.S_x", [](B b) {
                 return b.per_point({7}, [&](int p) { const Shapes f = b.shapes(p); return Vec<T>(f.x, f.x + 7); });
             }},
            {"3.S_y", [](B b) {
                 return b.per_point({7}, [&](int p) { const Shapes f = b.shapes(p); return Vec<T>(f.y, f.y + 7); });
             }},
            {"4.nodes", [](B b) { return seven_rows(b.nodes()); }},
            {"5.rdot", [](B b) { return b.per_point({2}, [&](int p) { return b.velocity(p); }); }},
            {"6.T", [](B b) { return Tensor<T>{{}, {b.kinetic_energy()}}; }},
            {"7.M", [](B b) { return b.mass().tensor(); }},
            {"8.epsilon_T", [](B b) { return Tensor<T>{{3}, triple_of(b.thermal_strain(false))}; }},
            {"9.J_0", [](B b) {
                 return b.per_point({2, 2}, [&](int p) { return two_by_two(b.initial_gradient(b.shapes(p), p)); });
             }},
            {"9.J", [](B b) {
                 return b.per_point({2, 2}, [&](int p) { return two_by_two(b.kinematics(b.shapes(p), p).J); });
             }},
            {"10.epsilon_m", [](B b) {
                 return b.per_point({2, 2}, [&](int p) {
                     return two_by_two(b.green_lagrange(b.kinematics(b.shapes(p), p), p));
                 });
             }},
            {"11.S_a", [](B b) { return b.of_metric(0); }},
            {"11.S_b", [](B b) { return b.of_metric(1); }},
            {"11.S_c", [](B b) { return b.of_metric(2); }},
            {"12.epsilon_f", [](B b) {
                 return b.per_point({3}, [&](int p) { return triple_of(b.strain(b.shapes(p), p)); });
             }},
            {"13.epsilon_1", [](B b) { return b.of_component(0); }},
            {"13.epsilon_2", [](B b) { return b.of_component(1); }},
            {"13.epsilon_3", [](B b) { return b.of_component(2); }},
            {"14.epsilon", [](B b) {
                 return b.per_point({3}, [&](int p) { return triple_of(b.elastic_strain(b.shapes(p), p)); });
             }},
            {"15.sigma", [](B b) {
                 return b.per_point({3}, [&](int p) { return triple_of(b.stress(b.shapes(p), p)); });
             }},
            {"16.D", [](B b) { return b.elasticity().tensor(); }},
            {"17.lambda", [](B b) { return Tensor<T>{{}, {b.lame()}}; }},
            {"17.mu", [](B b) { return Tensor<T>{{}, {b.shear_modulus()}}; }},
            {"18.U", [](B b) { return Tensor<T>{{}, {b.energy()}}; }},
            {"19.Q_e", [](B b) { return Tensor<T>{{14}, b.force()}; }},
            {"20.K", [](B b) { return b.stiffness().tensor(); }},
            {"21.K_1", [](B b) { return b.stiffness_part(1).tensor(); }},
            {"21.K_2", [](B b) { return b.stiffness_part(2).tensor(); }},
            {"21.K_3", [](B b) { return b.stiffness_part(3).tensor(); }},
            {"21.S_a1", [](B b) { return b.of_symmetric_sum(0); }},
            {"21.S_b1", [](B b) { return b.of_symmetric_sum(1); }},
            {"21.S_c1", [](B b) { return b.of_symmetric_sum(2); }},
            {"tangent.dQ_e", [](B b) { return b.tangent().tensor(); }},
            {"gravity.Q_w", [](B b) { return Tensor<T>{{14}, b.weight()}; }},
            {"22.eddot", [](B b) { return Tensor<T>{{14}, b.acceleration()}; }},
            {"22.residual", [](B b) { return Tensor<T>{{14}, b.residual()}; }},
        };
    }
};

// ------------------------------------------------------------------------------------------------ the cable element

template <class T> class Cable {
  public:
    Cable(const State<T>& state, const Given<T>& given_values) : s(state), given(given_values) {}

    using Answer = std::function<Tensor<T>(Cable&)>;
    static const vector<pair<string, Answer>>& answers() {
        static const vector<pair<string, Answer>> table = make_answers();
        return table;
    }

  private:
    State<T> s;
    const Given<T>& given;

    struct Shapes {
        T N[4], x[4], xx[4];
    };

    bool take(const char* name, int p, int length, T* out) const {
        const auto found = given.find(name);
        if (found == given.end()) return false;
        const size_t from = static_cast<size_t>(p < 0 ? 0 : p * length);
        if (found->second.size() < from + static_cast<size_t>(length)) throw runtime_error(string("given: ") + name);
        for (int i = 0; i < length; ++i) out[i] = found->second[from + static_cast<size_t>(i)];
        return true;
    }

    // Hermite's cubics: value and slope at both ends.
    Shapes shapes(T x, int p) const {
        static const int powers[4][4] = {{1, 0, -3, 2}, {0, 1, -2, 1}, {0, 0, 3, -2}, {0, 0, -1, 1}};
        const T l = s.l, a = x / l;
        Shapes out;
        for (int i = 0; i < 4; ++i) {
            int k[4] = {powers[i][0], powers[i][1], powers[i][2], powers[i][3]};
            if (m("c-s2-sign") && i == 1) k[2] = 2;
            if (m("c-s4-no-minus") && i == 3) k[2] = 1;
            T scale = i % 2 == 1 ? l : T(1);
            if (m("c-slopes-no-l")) scale = 1;
            out.N[i] = scale * (k[0] + a * (k[1] + a * (k[2] + a * k[3])));
            out.x[i] = scale * (k[1] + a * (2 * k[2] + a * (3 * k[3]))) / l;
            out.xx[i] = scale * (2 * k[2] + a * (6 * k[3])) / (l * l);
            if (m("c-sxx-one-l")) out.xx[i] *= l;
        }
        if (p >= 0) {
            take("cable.S", p, 4, out.N);
            take("cable.S_x", p, 4, out.x);
            take("cable.S_xx", p, 4, out.xx);
        }
        return out;
    }
    Shapes shapes(int p) const { return shapes(s.points[p][0], p); }

    array<T, 2> sum(const T* f, const Vec<T>& u) const {
        array<T, 2> out{};
        for (int a = 0; a < 4; ++a)
            for (int c = 0; c < 2; ++c) out[c] += f[a] * u[2 * a + c];
        return out;
    }

    // Strain or curvature at a place, with its first and second derivatives by the nodal coordinates.
    struct Measure {
        T value = 0, first[8] = {}, second[8][8] = {};
    };

    Measure axial(const Shapes& f, int p) const {
        auto d = sum(f.x, s.e);
        if (p >= 0) take("cable.r_x", p, 2, d.data());
        const T length = std::hypot(d[0], d[1]);
        T heat = s.model == "none" ? T(0) : s.alpha * s.dT;
        if (m("c-heat-plus")) heat = -heat;
        if (m("c-heat-missing")) heat = 0;
        if (m("c-heat-half")) heat /= 2;
        if (m("c-heat-always")) heat = s.alpha * s.dT;
        if (m("c-heat-plane-strain")) heat *= 1 + s.nu;
        if (m("c-heat-2d-only") && s.model == "1d") heat = 0;
        Measure out;
        if (m("c-green-lagrange")) {
            out.value = (length * length - 1) / 2 - heat;
            for (int i = 0; i < 8; ++i) {
                out.first[i] = f.x[i / 2] * d[i % 2];
                for (int j = 0; j < 8; ++j) out.second[i][j] = i % 2 == j % 2 ? f.x[i / 2] * f.x[j / 2] : T(0);
            }
            return out;
        }
        out.value = length - 1 - heat;
        if (m("c-stretch-free")) out.value = length / (1 + heat) - 1;
        const T stretched = m("c-stretch-free") ? 1 + heat : T(1);
        for (int i = 0; i < 8; ++i) {
            const T ti = d[i % 2] / length;
            out.first[i] = f.x[i / 2] * ti / stretched;
            for (int j = 0; j < 8; ++j) {
                const T same = i % 2 == j % 2 ? T(1) : T(0);
                out.second[i][j] = f.x[i / 2] * f.x[j / 2] * (same - ti * d[j % 2] / length) / length / stretched;
            }
        }
        return out;
    }

    // (r_x cross r_xx)/|r_x|^2: a quotient f/g.
    Measure curvature(const Shapes& f, int p) const {
        auto d = sum(f.x, s.e), b = sum(f.xx, s.e);
        if (p >= 0) take("cable.r_x", p, 2, d.data()), take("cable.r_xx", p, 2, b.data());
        T cross = d[0] * b[1] - d[1] * b[0], g = d[0] * d[0] + d[1] * d[1];
        T sign = 1;
        if (m("c-kappa-sign")) sign = -1;
        T df[8], dg[8], ddf[8][8], ddg[8][8];
        for (int i = 0; i < 8; ++i) {
            const int a = i / 2, c = i % 2;
            df[i] = c == 0 ? f.x[a] * b[1] - f.xx[a] * d[1] : f.xx[a] * d[0] - f.x[a] * b[0];
            dg[i] = 2 * f.x[a] * d[c];
            for (int j = 0; j < 8; ++j) {
                const int q = j / 2, k = j % 2;
                ddf[i][j] = c == k ? T(0) : (f.x[a] * f.xx[q] - f.xx[a] * f.x[q]) * (c == 0 ? T(1) : T(-1));
                ddg[i][j] = c == k ? 2 * f.x[a] * f.x[q] : T(0);
            }
        }
        if (m("c-kappa-not-divided"))
            for (int i = 0; i < 8; ++i) {
                g = 1, dg[i] = 0;
                for (int j = 0; j < 8; ++j) ddg[i][j] = 0;
            }
        if (m("c-kappa-cubed")) { // divided by |r_x|^3 = g^(3/2)
            const T root = std::sqrt(g), cube = g * root;
            for (int i = 0; i < 8; ++i)
                for (int j = 0; j < 8; ++j)
                    ddg[i][j] = T(3) / T(2) * root * ddg[i][j] + T(3) / T(4) / root * dg[i] * dg[j];
            for (int i = 0; i < 8; ++i) dg[i] *= T(3) / T(2) * root;
            g = cube;
        }
        if (m("c-kappa-second-derivative")) { // |r_xx|, the small-deflection curvature
            const T size = std::hypot(b[0], b[1]);
            Measure out;
            out.value = size;
            for (int i = 0; i < 8 && size > T(0); ++i) {
                out.first[i] = f.xx[i / 2] * b[i % 2] / size;
                for (int j = 0; j < 8; ++j)
                    out.second[i][j] = f.xx[i / 2] * f.xx[j / 2] *
                                       ((i % 2 == j % 2 ? T(1) : T(0)) - b[i % 2] * b[j % 2] / (size * size)) / size;
            }
            return out;
        }
        Measure out;
        out.value = sign * cross / g;
        for (int i = 0; i < 8; ++i) {
            out.first[i] = sign * (df[i] / g - cross * dg[i] / (g * g));
            for (int j = 0; j < 8; ++j)
                out.second[i][j] = sign * (ddf[i][j] / g - (df[i] * dg[j] + dg[i] * df[j]) / (g * g) -
                                           cross * ddg[i][j] / (g * g) + 2 * cross * dg[i] * dg[j] / (g * g * g));
        }
        return out;
    }

    T area() const {
        if (m("c-area-square")) return s.h * s.h;
        return s.h * s.w;
    }
    T inertia() const {
        if (m("c-inertia-w-h")) return s.h * s.w * s.w * s.w / 12;
        if (m("c-inertia-three")) return s.w * s.h * s.h * s.h / 3;
        if (m("c-inertia-no-twelve")) return s.w * s.h * s.h * s.h;
        return s.w * s.h * s.h * s.h / 12;
    }

    // Sums over the Gauss points of both parts of the energy: measure, stiffness, length.
    void integrate(const std::function<void(const Measure&, T, T)>& add) const {
        int stretch = 5, bend = 3;
        if (m("c-axial-three")) stretch = 3;
        if (m("c-axial-one")) stretch = 1;
        if (m("c-bending-two")) bend = 2;
        if (m("c-bending-five")) bend = 5;
        if (m("c-reduced")) stretch = 4, bend = 2;
        T E = s.E;
        if (m("c-plane-strain")) E /= 1 - s.nu * s.nu;
        for (const auto& q : gauss<T>(stretch))
            add(axial(shapes(s.l * (1 + q.first) / 2, -1), -1), E * area(), q.second * s.l / 2);
        for (const auto& q : gauss<T>(bend))
            add(curvature(shapes(s.l * (1 + q.first) / 2, -1), -1), E * inertia(), q.second * s.l / 2);
    }

    T energy() const {
        T sum = 0;
        integrate([&](const Measure& k, T stiffness, T length) { sum += stiffness * k.value * k.value * length; });
        if (m("c-energy-no-half")) return sum;
        return sum / 2;
    }

    Vec<T> force() const {
        Vec<T> Q(8, T(0));
        if (take("cable.Q_e", -1, 8, Q.data())) return Q;
        integrate([&](const Measure& k, T stiffness, T length) {
            for (int i = 0; i < 8; ++i) Q[i] += stiffness * k.value * k.first[i] * length;
        });
        if (m("c-force-minus")) for (T& part : Q) part = -part;
        return Q;
    }

    Matrix<T> tangent() const {
        Matrix<T> K(8, 8);
        integrate([&](const Measure& k, T stiffness, T length) {
            for (int i = 0; i < 8; ++i)
                for (int j = 0; j < 8; ++j) {
                    T part = k.first[i] * k.first[j] + k.value * k.second[i][j];
                    if (m("c-tangent-no-geometric")) part = k.first[i] * k.first[j];
                    K(i, j) += stiffness * part * length;
                }
        });
        return K;
    }

    Matrix<T> mass() const {
        Matrix<T> M(8, 8);
        if (take("cable.M", -1, 64, M.data.data())) return M;
        T line = s.rho * s.h * s.w;
        if (m("c-mass-no-area")) line = s.rho;
        if (m("c-mass-height-twice")) line = s.rho * s.h * s.h;
        for (const auto& q : gauss<T>(m("c-mass-three") ? 3 : 4)) {
            const Shapes f = shapes(s.l * (1 + q.first) / 2, -1);
            for (int a = 0; a < 4; ++a)
                for (int b = 0; b < 4; ++b)
                    for (int c = 0; c < 2; ++c)
                        M(2 * a + c, 2 * b + c) += line * f.N[a] * f.N[b] * q.second * s.l / 2;
        }
        return M;
    }

    Vec<T> weight() const {
        Vec<T> Q(8, T(0));
        if (take("cable.Q_w", -1, 8, Q.data())) return Q;
        const T line = s.rho * s.h * s.w;
        for (const auto& q : gauss<T>(4)) {
            const Shapes f = shapes(s.l * (1 + q.first) / 2, -1);
            for (int i = 0; i < 8; ++i) Q[i] += line * f.N[i / 2] * s.gravity[i % 2] * q.second * s.l / 2;
        }
        if (m("c-weight-lumped"))
            for (int i = 0; i < 8; ++i) Q[i] = i / 2 % 2 == 0 ? line * s.l * s.gravity[i % 2] / 2 : T(0);
        if (m("c-weight-minus")) for (T& part : Q) part = -part;
        return Q;
    }

    Vec<T> acceleration() const {
        const Vec<T> Qe = force(), Qw = weight();
        Vec<T> b(8);
        for (int i = 0; i < 8; ++i) b[i] = m("c-plus-force") ? Qw[i] + Qe[i] : Qw[i] - Qe[i];
        return solve(mass(), b);
    }

    Tensor<T> per_point(const vector<int>& shape, const std::function<Vec<T>(int)>& at) const {
        Tensor<T> out;
        out.shape = {static_cast<int>(s.points.size())};
        out.shape.insert(out.shape.end(), shape.begin(), shape.end());
        for (int p = 0; p < out.shape[0]; ++p)
            for (T number : at(p)) out.data.push_back(number);
        return out;
    }
    Tensor<T> functions(T (Shapes::*which)[4]) const {
        return per_point({4}, [&](int p) {
            const Shapes f = shapes(p);
            return Vec<T>(f.*which, f.*which + 4);
        });
    }
    Tensor<T> field(T (Shapes::*which)[4]) const {
        return per_point({2}, [&](int p) {
            const Shapes f = shapes(p);
            const auto r = sum(f.*which, s.e);
            return Vec<T>{r[0], r[1]};
        });
    }

    static vector<pair<string, Answer>> make_answers() {
        using C = Cable&;
        return {
            {"cable.S", [](C c) { return c.functions(&Shapes::N); }},
            {"cable.S_x", [](C c) { return c.functions(&Shapes::x); }},
            {"cable.S_xx", [](C c) { return c.functions(&Shapes::xx); }},
            {"cable.r", [](C c) { return c.field(&Shapes::N); }},
            {"cable.r_x", [](C c) { return c.field(&Shapes::x); }},
            {"cable.r_xx", [](C c) { return c.field(&Shapes::xx); }},
            {"cable.epsilon", [](C c) {
                 return c.per_point({}, [&](int p) { return Vec<T>{c.axial(c.shapes(p), p).value}; });
             }},
            {"cable.kappa", [](C c) {
                 return c.per_point({}, [&](int p) { return Vec<T>{c.curvature(c.shapes(p), p).value}; });
             }},
            {"cable.T", [](C c) {
                 const T twice = dot(c.s.edot, times(c.mass(), c.s.edot));
                 return Tensor<T>{{}, {m("c-kinetic-no-half") ? twice : twice / 2}};
             }},
            {"cable.M", [](C c) { return c.mass().tensor(); }},
            {"cable.U", [](C c) { return Tensor<T>{{}, {c.energy()}}; }},
            {"cable.Q_e", [](C c) { return Tensor<T>{{8}, c.force()}; }},
            {"cable.tangent", [](C c) { return c.tangent().tensor(); }},
            {"cable.Q_w", [](C c) { return Tensor<T>{{8}, c.weight()}; }},
            {"cable.eddot", [](C c) { return Tensor<T>{{8}, c.acceleration()}; }},
        };
    }
};

// ------------------------------------------------------------------------------------------------ (23): a structure

template <class T> class Structure {
  public:
    Structure(const Json& state, const Given<T>& given_values)
        : given(given_values), n(static_cast<int>(value("23.Q_e").size())),
          c(static_cast<int>(value("23.Phi_q").size()) / n) {
        flatten(state.at("q_ddot"), q_ddot);
        flatten(state.at("lambda"), lambda);
    }

    Tensor<T> answer(const string& name) const {
        if (name == "23.constraint_force") return {{n}, constraint_force()};
        if (name == "23.residual") return {{n}, residual()};
        const Vec<T> x = solution();
        if (name == "23.acceleration") return {{n}, Vec<T>(x.begin(), x.begin() + n)};
        return {{c}, Vec<T>(x.begin() + n, x.end())};
    }

  private:
    const Given<T>& given;
    const int n, c;
    Vec<T> q_ddot, lambda;

    const Vec<T>& value(const string& name) const {
        const auto found = given.find(name);
        if (found == given.end()) throw runtime_error("given: " + name + " is missing");
        return found->second;
    }

    Vec<T> constraint_force() const {
        const Vec<T>& phi = value("23.Phi_q");
        Vec<T> out(static_cast<size_t>(n), T(0));
        for (int i = 0; i < n; ++i)
            for (int k = 0; k < c; ++k) {
                // As printed (E4), a program that keeps the matrix in one list reads n rows of c numbers.
                const int place = m("E4-printed") ? i * c + k : k * n + i;
                if (m("23-last-constraint") && k == c - 1) continue;
                out[i] += phi[place] * lambda[k];
            }
        if (m("23-force-minus")) for (T& part : out) part = -part;
        return out;
    }

    Vec<T> residual() const {
        const Vec<T>&mass = value("23.m"), &Qe = value("23.Q_e"), &f = value("23.f");
        const Vec<T> constraint = constraint_force();
        Vec<T> out(static_cast<size_t>(n));
        for (int i = 0; i < n; ++i) {
            T inertia = 0;
            for (int j = 0; j < n; ++j) inertia += mass[i * n + j] * q_ddot[j];
            out[i] = inertia + Qe[i] + constraint[i] - f[i];
            if (m("23-residual-sign")) out[i] = inertia + Qe[i] - constraint[i] - f[i];
            if (m("23-residual-load-sign")) out[i] = inertia + Qe[i] + constraint[i] + f[i];
            if (m("23-residual-no-force")) out[i] = inertia + constraint[i] - f[i];
        }
        return out;
    }

    Vec<T> solution() const {
        const Vec<T>&mass = value("23.m"), &Qe = value("23.Q_e"), &f = value("23.f"), &phi = value("23.Phi_q");
        Matrix<T> A(n + c, n + c);
        Vec<T> b(static_cast<size_t>(n + c), T(0));
        for (int i = 0; i < n; ++i) {
            for (int j = 0; j < n; ++j) A(i, j) = mass[i * n + j];
            for (int k = 0; k < c; ++k) A(i, n + k) = A(n + k, i) = phi[k * n + i];
            b[i] = f[i] - Qe[i];
            if (m("23-solve-no-force")) b[i] = f[i];
            if (m("23-solve-plus-force")) b[i] = f[i] + Qe[i];
        }
        Vec<T> x = solve(A, b);
        if (m("23-lambda-minus"))
            for (int k = 0; k < c; ++k) x[n + k] = -x[n + k];
        return x;
    }
};

// ------------------------------------------------------------------------------------------------------ conventions

enum class Role { plain, nodal_vectors, coordinates, forces, forces_matrix, functions, shape_matrix };

static Role role_of(const string& name) {
    static const std::map<string, Role> roles = {
        {"4.nodes", Role::nodal_vectors},   {"A.2.e", Role::coordinates},       {"22.eddot", Role::coordinates},
        {"cable.eddot", Role::coordinates}, {"19.Q_e", Role::forces},           {"22.residual", Role::forces},
        {"gravity.Q_w", Role::forces},      {"cable.Q_e", Role::forces},        {"cable.Q_w", Role::forces},
        {"7.M", Role::forces_matrix},       {"20.K", Role::forces_matrix},      {"21.K_1", Role::forces_matrix},
        {"21.K_2", Role::forces_matrix},    {"21.K_3", Role::forces_matrix},    {"11.S_a", Role::forces_matrix},
        {"11.S_b", Role::forces_matrix},    {"11.S_c", Role::forces_matrix},    {"21.S_a1", Role::forces_matrix},
        {"21.S_b1", Role::forces_matrix},   {"21.S_c1", Role::forces_matrix},   {"tangent.dQ_e", Role::forces_matrix},
        {"cable.M", Role::forces_matrix},   {"cable.tangent", Role::forces_matrix},
        {"3.S", Role::functions},           {"3.S_x", Role::functions},         {"3.S_y", Role::functions},
        {"cable.S", Role::functions},       {"cable.S_x", Role::functions},     {"cable.S_xx", Role::functions},
        {"2.S", Role::shape_matrix}};
    const auto found = roles.find(name);
    return found == roles.end() ? Role::plain : found->second;
}

// Puts the numbers of a right answer in the order and scale of another layout of the nodal coordinates.
template <class T> Tensor<T> in_layout(const string& name, const Tensor<T>& value, const Layout<T>& there) {
    Tensor<T> out = value;
    const int n = static_cast<int>(there.place.size()), vectors = n / 2;
    const auto& place = there.place;
    switch (role_of(name)) {
    case Role::plain: break;
    case Role::nodal_vectors:
        for (int a = 0; a < vectors; ++a)
            for (int c = 0; c < 2; ++c)
                out.data[2 * a + c] = there.vector_scale[a] * value.data[2 * there.vectors[a] + c];
        break;
    case Role::coordinates:
        for (int i = 0; i < n; ++i) out.data[i] = there.scale[i] * value.data[place[i]];
        break;
    case Role::forces:
        for (int i = 0; i < n; ++i) out.data[i] = value.data[place[i]] / there.scale[i];
        break;
    case Role::forces_matrix:
        for (size_t from = 0; from < value.data.size(); from += static_cast<size_t>(n * n))
            for (int i = 0; i < n; ++i)
                for (int j = 0; j < n; ++j)
                    out.data[from + i * n + j] =
                        value.data[from + place[i] * n + place[j]] / there.scale[i] / there.scale[j];
        break;
    case Role::functions:
        for (size_t from = 0; from < value.data.size(); from += static_cast<size_t>(vectors))
            for (int a = 0; a < vectors; ++a)
                out.data[from + a] = value.data[from + there.vectors[a]] / there.vector_scale[a];
        break;
    case Role::shape_matrix:
        for (size_t from = 0; from < value.data.size(); from += static_cast<size_t>(n))
            for (int i = 0; i < n; ++i) out.data[from + i] = value.data[from + place[i]] / there.scale[i];
        break;
    }
    return out;
}

// Lists a matrix, the two last lengths of the shape, by columns.
template <class T> Tensor<T> by_columns(const Tensor<T>& value, bool per_point) {
    const size_t lists = per_point ? 1 : 0;
    if (value.shape.size() != lists + 2) return value;
    Tensor<T> out = value;
    const int rows = value.shape[lists], cols = value.shape[lists + 1];
    std::swap(out.shape[lists], out.shape[lists + 1]);
    for (size_t from = 0; from < value.data.size(); from += static_cast<size_t>(rows * cols))
        for (int i = 0; i < rows; ++i)
            for (int j = 0; j < cols; ++j) out.data[from + j * rows + i] = value.data[from + i * cols + j];
    return out;
}

static bool is_per_point(const string& name) {
    static const std::set<string> names = {
        "A.1.r",        "A.1.r_x",      "A.1.r_y",      "A.4.r",      "1.r",       "2.S",       "3.S",
        "3.S_x",        "3.S_y",        "5.rdot",       "9.J_0",      "9.J",       "10.epsilon_m", "11.S_a",
        "11.S_b",       "11.S_c",       "12.epsilon_f", "13.epsilon_1", "13.epsilon_2", "13.epsilon_3",
        "14.epsilon",   "15.sigma",     "21.S_a1",      "21.S_b1",    "21.S_c1",   "cable.S",   "cable.S_x",
        "cable.S_xx",   "cable.r",      "cable.r_x",    "cable.r_xx", "cable.epsilon", "cable.kappa"};
    return names.count(name) > 0;
}

static bool is_strain(const string& name) {
    return name == "8.epsilon_T" || name == "12.epsilon_f" || name == "14.epsilon";
}

// ---------------------------------------------------------------------------------------------------------- program

template <class T> string number(T value) {
    char text[64];
    const int digits = options.digits > 0 ? options.digits : options.single ? 9 : 17;
    if (options.talk == "fortran") {
        std::snprintf(text, sizeof text, "%.*E", digits - 1, static_cast<double>(std::abs(value)));
        const string plain = text; // d.dddE+xx
        const size_t at = plain.find('E');
        const string figures = plain.substr(0, 1) + (at > 2 ? plain.substr(2, at - 2) : "");
        const int exponent = value == T(0) ? 0 : std::atoi(plain.c_str() + at + 1) + 1;
        std::snprintf(text, sizeof text, "%s0.%sD%+03d", value < T(0) ? "-" : "", figures.c_str(), exponent);
        return text;
    }
    if (options.decimals >= 0)
        std::snprintf(text, sizeof text, "%.*f", options.decimals, static_cast<double>(value));
    else
        std::snprintf(text, sizeof text, "%.*g", digits, static_cast<double>(value));
    string out = text;
    if (options.talk == "leading-dot") {
        if (out.compare(0, 2, "0.") == 0) out = out.substr(1);
        if (out.compare(0, 3, "-0.") == 0) out = "-" + out.substr(2);
    }
    if (options.talk == "trailing-dot" && out.find_first_of(".e") == string::npos) out += ".";
    if (options.talk == "plus" && out[0] != '-') out = "+" + out;
    return out;
}

template <class T> void write_list(const Tensor<T>& value, size_t level, size_t& at, string& out) {
    if (level == value.shape.size()) {
        out += number(value.data[at++]);
        return;
    }
    out += "[";
    for (int i = 0; i < value.shape[level]; ++i) {
        if (i > 0) out += ", ";
        write_list(value, level + 1, at, out);
    }
    out += options.talk == "trailing-comma" ? ",]" : "]";
}

template <class T> class Program {
  public:
    string line(const string& question) {
        const Json j = Parser(question).document();
        if (j.find("hello")) return hello();
        const string id = j.at("id").words, name = j.at("equation").words;
        const string head = "\"id\": \"" + id + "\"";
        if (!implemented(name)) return "{" + head + ", \"not_implemented\": true}";
        try {
            const Tensor<T> value = converted(name, j, answer(name, j));
            size_t at = 0;
            string text;
            write_list(value, 0, at, text);
            if (options.talk == "nan" && name == "18.U") text = "NaN";
            if (options.talk == "pretty") return "{\n  " + head + ",\n  \"value\": " + broken(text) + "\n}";
            return "{" + head + ", \"value\": " + text + "}";
        } catch (const runtime_error& error) {
            return "{" + head + ", \"error\": \"" + error.what() + "\"}";
        }
    }

  private:
    Memory<T> memory;

    static vector<string> structure_names() {
        return {"23.constraint_force", "23.residual", "23.acceleration", "23.lambda"};
    }

    static bool implemented(const string& name) {
        if (!options.only.empty() && !options.only.count(name)) return false;
        for (const auto& known : Beam<T>::answers()) if (known.first == name) return true;
        for (const auto& known : Cable<T>::answers()) if (known.first == name) return true;
        for (const auto& known : structure_names()) if (known == name) return true;
        return false;
    }

    static string hello() {
        string list;
        const auto add = [&](const string& name) {
            if (implemented(name)) list += (list.empty() ? "\"" : ", \"") + name + "\"";
        };
        for (const auto& known : Beam<T>::answers()) add(known.first);
        for (const auto& known : Cable<T>::answers()) add(known.first);
        for (const auto& known : structure_names()) add(known);
        string out = "{\"hello\": {\"name\": \"stranger\", ";
        if (!options.given.empty()) out += "\"given\": true, ";
        if (!options.declare.empty()) out += options.declare + ", ";
        return out + "\"quantities\": [" + list + "]}}";
    }

    // Breaks the lines of a list as a pretty printer does.
    static string broken(const string& text) {
        string out;
        for (char c : text) {
            out += c;
            if (c == ',') out += "\n   ";
        }
        return out;
    }

    Tensor<T> answer(const string& name, const Json& j) {
        ++memory.questions;
        Given<T> given;
        const bool of_structure = name.compare(0, 3, "23.") == 0;
        if (const Json* values = j.find("given"))
            if (options.given == "read" || of_structure)
                for (const auto& member : values->members) flatten(member.second, given[member.first]);
        if (of_structure) return Structure<T>(j.at("state"), given).answer(name);
        Tensor<T> out;
        if (name.compare(0, 6, "cable.") == 0) {
            Cable<T> cable(read_state<T>(j.at("state"), true), given);
            for (const auto& known : Cable<T>::answers())
                if (known.first == name) out = known.second(cable);
        } else {
            Beam<T> beam(read_state<T>(j.at("state"), false), given, memory);
            for (const auto& known : Beam<T>::answers())
                if (known.first == name) out = known.second(beam);
        }
        if (options.memory == "counter" && memory.questions > 200)
            for (T& part : out.data) part *= T(11) / T(10);
        return out;
    }

    // The right answer in another convention.
    Tensor<T> converted(const string& name, const Json& j, Tensor<T> value) {
        const string& convention = options.convention.empty() ? options.convention_in : options.convention;
        if (convention.empty() || name.compare(0, 3, "23.") == 0) return value;
        const bool cable = name.compare(0, 6, "cable.") == 0;
        const State<T> s = read_state<T>(j.at("state"), cable);
        const size_t points = is_per_point(name) ? static_cast<size_t>(value.shape[0]) : 1;
        if (convention == "engineering-shear") {
            if (is_strain(name))
                for (size_t p = 0; p < points; ++p) value.data[3 * p + 2] *= 2;
            if (name == "13.epsilon_3") for (T& part : value.data) part *= 2;
            if (name == "16.D") value.data[8] /= 2;
        } else if (convention == "order-11-12-22") {
            if (is_strain(name) || name == "15.sigma")
                for (size_t p = 0; p < points; ++p) std::swap(value.data[3 * p + 1], value.data[3 * p + 2]);
            if (name == "16.D") {
                const Tensor<T> D = value;
                const int order[3] = {0, 2, 1};
                for (int i = 0; i < 3; ++i)
                    for (int k = 0; k < 3; ++k) value.data[3 * i + k] = D.data[3 * order[i] + order[k]];
            }
        } else if (convention == "symmetric-S_c") {
            if (name == "11.S_c")
                for (size_t from = 0; from < value.data.size(); from += 196)
                    for (size_t i = 0; i < 14; ++i)
                        for (size_t k = 0; k < i; ++k) {
                            T &a = value.data[from + 14 * i + k], &b = value.data[from + 14 * k + i];
                            a = b = (a + b) / 2;
                        }
        } else if (convention == "U-without-constant") {
            if (name == "18.U") {
                const Vec<T> heat = answer("8.epsilon_T", j).data, D = answer("16.D", j).data;
                const T la = D[1], two_mu = D[8], trace = heat[0] + heat[1];
                const T square = heat[0] * heat[0] + heat[1] * heat[1] + 2 * heat[2] * heat[2];
                value.data[0] -= (la * trace * trace + two_mu * square) / 2 * s.l * s.h * s.w;
            }
        } else if (convention == "column-major") {
            return by_columns(value, is_per_point(name));
        } else if (convention == "heat-in-law") {
            if (name == "14.epsilon") return answer("12.epsilon_f", j);
        } else if (convention != "degrees") {
            return in_layout(name, value, layout<T>(convention, cable, s.l, s.h));
        }
        return value;
    }
};

template <class T> int run() {
    Program<T> program;
    string question, kept;
    if (options.talk == "banner") std::cout << "Stranger 1.0, planar beams\nready" << std::endl;
    while (std::getline(std::cin, question)) {
        if (question.empty()) continue;
        string out;
        try {
            out = program.line(question);
        } catch (const runtime_error& error) {
            std::cerr << error.what() << std::endl;
            return 2;
        }
        if (options.talk == "debugging") std::cout << "debug: answered" << std::endl;
        if (options.talk == "no-flush")
            kept += out + "\n";
        else
            std::cout << out << std::endl;
    }
    std::cout << kept;
    return 0;
}

int main(int count, char** words) {
    const auto fail = [](const string& message) {
        std::cerr << message << std::endl;
        return 2;
    };
    for (int i = 1; i < count; ++i) {
        const string key = words[i];
        if (key == "--float") {
            options.single = true;
            continue;
        }
        if (i + 1 == count) return fail(key + " needs a value");
        const string value = words[++i];
        if (key == "--mistake") options.mistakes.insert(value);
        else if (key == "--convention") options.convention = value;
        else if (key == "--convention-in") options.convention_in = value;
        else if (key == "--memory") options.memory = value;
        else if (key == "--given") options.given = value;
        else if (key == "--talk") options.talk = value;
        else if (key == "--route") options.route = value;
        else if (key == "--declare") options.declare = value;
        else if (key == "--print") options.digits = std::atoi(value.c_str());
        else if (key == "--fixed") options.decimals = std::atoi(value.c_str());
        else if (key == "--only") {
            size_t from = 0;
            while (from <= value.size()) {
                const size_t comma = std::min(value.find(',', from), value.size());
                options.only.insert(value.substr(from, comma - from));
                from = comma + 1;
            }
        } else
            return fail("unknown option " + key + "; see README.md");
    }
    return options.single ? run<float>() : run<double>();
}
