#include "io/recording_bodies.hpp"

#include "io/limits.hpp"
#include "io/scene_json.hpp"

#include <carom/error.hpp>

#include <cmath>
#include <limits>

namespace carom::io {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

std::optional<double> optional_of(double value)
{
    return std::isnan(value) ? std::nullopt : std::optional(value);
}

/// The same numbers in writing and in reading: columns are made by `each`, row by row.
template <class Items, class Each>
std::vector<double> column_of(const Items& items, const Each& each)
{
    std::vector<double> column;
    column.reserve(items.size());
    for (const auto& item : items) column.push_back(each(item));
    return column;
}

template <class T, class Items, class Each>
std::vector<T> integers_of(const Items& items, const Each& each)
{
    std::vector<T> column;
    column.reserve(items.size());
    for (const auto& item : items) column.push_back(static_cast<T>(each(item)));
    return column;
}

Bytes spheres_data(const std::vector<Sphere>& spheres)
{
    ColumnWriter out;
    out.add(column_of(spheres, [](const Sphere& s) { return s.radius; }));
    out.add(column_of(spheres, [](const Sphere& s) { return s.mass; }));
    for (int k = 0; k < 3; ++k) out.add(column_of(spheres, [k](const Sphere& s) { return s.position[k]; }));
    for (int k = 0; k < 3; ++k) out.add(column_of(spheres, [k](const Sphere& s) { return s.velocity[k]; }));
    out.add(integers_of<std::int32_t>(spheres, [](const Sphere& s) { return s.material; }));
    out.add(integers_of<std::uint8_t>(spheres, [](const Sphere& s) { return s.fixed; }));
    return out.bytes();
}

Bytes planes_data(const std::vector<Plane>& planes)
{
    ColumnWriter out;
    for (int k = 0; k < 3; ++k) out.add(column_of(planes, [k](const Plane& p) { return p.normal[k]; }));
    out.add(column_of(planes, [](const Plane& p) { return p.offset; }));
    out.add(column_of(planes, [](const Plane& p) { return p.thickness.value_or(none); }));
    out.add(integers_of<std::int32_t>(planes, [](const Plane& p) { return p.material; }));
    return out.bytes();
}

Bytes materials_data(const std::vector<Material>& materials)
{
    ColumnWriter out;
    out.add(column_of(materials, [](const Material& m) { return m.restitution; }));
    out.add(column_of(materials, [](const Material& m) { return m.tangential; }));
    return out.bytes();
}

Bytes contacts_data(const std::vector<ContactRule>& contacts)
{
    ColumnWriter out;
    out.add(integers_of<std::int32_t>(contacts, [](const ContactRule& c) { return c.a; }));
    out.add(integers_of<std::int32_t>(contacts, [](const ContactRule& c) { return c.b; }));
    out.add(column_of(contacts, [](const ContactRule& c) { return c.restitution.value_or(none); }));
    out.add(column_of(contacts, [](const ContactRule& c) { return c.tangential.value_or(none); }));
    out.add(column_of(contacts, [](const ContactRule& c) { return c.attenuation.value_or(none); }));
    return out.bytes();
}

template <class Items>
BodiesRow ids_row(const char* kind, const Items& items)
{
    std::vector<std::string> ids;
    for (const auto& item : items) ids.push_back(item.id);
    const std::string text = strings_json(ids);
    ColumnWriter out;
    out.add(std::vector<std::uint8_t>(text.begin(), text.end()));
    return {kind, static_cast<std::int64_t>(text.size()), out.bytes()};
}

template <class Items, class Set>
void read_column(ColumnReader& in, Items& items, const Set& set)
{
    std::vector<double> column;
    in.read(column);
    for (std::size_t i = 0; i < items.size(); ++i) set(items[i], column[i]);
}

template <class T, class Items, class Set>
void read_integers(ColumnReader& in, Items& items, const Set& set)
{
    std::vector<T> column;
    in.read(column);
    for (std::size_t i = 0; i < items.size(); ++i) set(items[i], column[i]);
}

void read_spheres(ColumnReader& in, std::vector<RecordedSphere>& spheres, std::vector<RecordedStart>& starts)
{
    read_column(in, spheres, [](RecordedSphere& s, double x) { s.radius = x; });
    read_column(in, spheres, [](RecordedSphere& s, double x) { s.mass = x; });
    for (int k = 0; k < 3; ++k) read_column(in, starts, [k](RecordedStart& s, double x) { s.position[k] = x; });
    for (int k = 0; k < 3; ++k) read_column(in, starts, [k](RecordedStart& s, double x) { s.velocity[k] = x; });
    read_integers<std::int32_t>(in, spheres, [](RecordedSphere& s, std::int32_t m) { s.material = m; });
    read_integers<std::uint8_t>(in, spheres, [](RecordedSphere& s, std::uint8_t f) { s.fixed = f != 0; });
}

void read_planes(ColumnReader& in, std::vector<Plane>& planes)
{
    for (int k = 0; k < 3; ++k) read_column(in, planes, [k](Plane& p, double x) { p.normal[k] = x; });
    read_column(in, planes, [](Plane& p, double x) { p.offset = x; });
    read_column(in, planes, [](Plane& p, double x) { p.thickness = optional_of(x); });
    read_integers<std::int32_t>(in, planes, [](Plane& p, std::int32_t m) { p.material = m; });
}

void read_contacts(ColumnReader& in, std::vector<ContactRule>& contacts)
{
    read_integers<std::int32_t>(in, contacts, [](ContactRule& c, std::int32_t m) { c.a = m; });
    read_integers<std::int32_t>(in, contacts, [](ContactRule& c, std::int32_t m) { c.b = m; });
    read_column(in, contacts, [](ContactRule& c, double x) { c.restitution = optional_of(x); });
    read_column(in, contacts, [](ContactRule& c, double x) { c.tangential = optional_of(x); });
    read_column(in, contacts, [](ContactRule& c, double x) { c.attenuation = optional_of(x); });
}

bool positive(double x)
{
    return x > 0 && std::isfinite(x);
}

bool fraction(double x)
{
    return x >= 0 && x <= 1;
}

bool sound(const RecordedSphere& s)
{
    return positive(s.radius) && positive(s.mass);
}

bool sound(const Plane& p)
{
    return p.normal.allFinite() && std::abs(p.normal.squaredNorm() - 1) < recorded_normal_error &&
           std::isfinite(p.offset) && (!p.thickness || (*p.thickness >= 0 && std::isfinite(*p.thickness)));
}

}  // namespace

const std::vector<std::string>& bodies_kinds()
{
    static const std::vector<std::string> kinds{"spheres",   "sphere_ids", "planes",
                                                "plane_ids", "materials",  "contacts"};
    return kinds;
}

std::int64_t most_in_row(const std::string& kind)
{
    if (kind == "spheres") return most_bodies;
    return kind.ends_with("_ids") ? most_bytes_of_ids : most_written_by_hand;
}

std::vector<BodiesRow> bodies_rows(const Scene& scene)
{
    const auto count = [](const auto& items) { return static_cast<std::int64_t>(items.size()); };
    return {{"spheres", count(scene.spheres), spheres_data(scene.spheres)},
            ids_row("sphere_ids", scene.spheres),
            {"planes", count(scene.planes), planes_data(scene.planes)},
            ids_row("plane_ids", scene.planes),
            {"materials", count(scene.materials), materials_data(scene.materials)},
            {"contacts", count(scene.contacts), contacts_data(scene.contacts)}};
}

void read_bodies_row(RecordedRun& run, const BodiesRow& row, const std::string& file)
{
    const auto n = static_cast<std::size_t>(row.count);
    ColumnReader in(row.data, n, file);
    if (row.kind == "spheres") {
        run.spheres.resize(n);
        run.starts.resize(n);
        read_spheres(in, run.spheres, run.starts);
    } else if (row.kind == "planes") {
        run.planes.resize(n);
        read_planes(in, run.planes);
    } else if (row.kind == "materials") {
        run.materials.resize(n);
        read_column(in, run.materials, [](Material& m, double x) { m.restitution = x; });
        read_column(in, run.materials, [](Material& m, double x) { m.tangential = x; });
    } else if (row.kind == "contacts") {
        run.contacts.resize(n);
        read_contacts(in, run.contacts);
    } else {
        return;  // ids are read when somebody asks for one
    }
    in.finish();
}

void check_bodies(const RecordedRun& run, const std::string& file)
{
    const auto known = [&](int material) {
        return material >= 0 && static_cast<std::size_t>(material) < run.materials.size();
    };
    const auto expect = [&](bool holds, const char* what) {
        if (!holds) throw InputError({file + ": damaged: " + what});
    };
    for (const RecordedSphere& s : run.spheres) expect(sound(s) && known(s.material), "a sphere that cannot be");
    for (const RecordedStart& s : run.starts)
        expect(s.position.allFinite() && s.velocity.allFinite(), "a sphere that cannot be");
    for (const Plane& p : run.planes) expect(sound(p) && known(p.material), "a plane that cannot be");
    for (const Material& m : run.materials)
        expect(fraction(m.restitution) && fraction(m.tangential), "a material that cannot be");
    for (const ContactRule& c : run.contacts)
        expect(known(c.a) && known(c.b) && fraction(c.restitution.value_or(0)) && fraction(c.tangential.value_or(0)) &&
                   fraction(c.attenuation.value_or(0)),
               "a contact rule that cannot be");
}

std::vector<std::string> ids_of(const BodiesRow& row, const std::string& file)
{
    ColumnReader in(row.data, static_cast<std::size_t>(row.count), file);
    std::vector<std::uint8_t> text;
    in.read(text);
    in.finish();
    return strings_of_json(std::string(text.begin(), text.end()), file);
}

Bytes bytes_of(std::span<const Vec3> vectors)
{
    Bytes bytes(vectors.size() * 3 * sizeof(double));
    for (std::size_t i = 0; i < vectors.size(); ++i)
        std::memcpy(bytes.data() + i * 3 * sizeof(double), vectors[i].data(), 3 * sizeof(double));
    return bytes;
}

std::vector<Vec3> vectors_of(std::span<const unsigned char> bytes, const std::string& file)
{
    constexpr std::size_t size = 3 * sizeof(double);
    std::vector<Vec3> vectors(bytes.size() / size);
    for (std::size_t i = 0; i < vectors.size(); ++i) std::memcpy(vectors[i].data(), bytes.data() + i * size, size);
    bool finite = bytes.size() % size == 0;
    for (const Vec3& v : vectors) finite = finite && v.allFinite();
    if (!finite) throw InputError({file + ": damaged: accelerations that cannot be"});
    return vectors;
}

}  // namespace carom::io
