#include "io/recording_bodies.hpp"

#include "io/limits.hpp"
#include "io/recording_columns.hpp"
#include "io/scene_json.hpp"

#include <carom/error.hpp>

#include <cmath>

namespace carom::io {

namespace {

template <class Record, class Columns>
BodiesRow row_of(const char* kind, const Columns& columns, const std::vector<Record>& records)
{
    return {kind, static_cast<std::int64_t>(records.size()), pack(columns, std::span(records))};
}

std::vector<SphereRow> sphere_rows(const std::vector<Sphere>& spheres)
{
    std::vector<SphereRow> rows;
    rows.reserve(spheres.size());
    for (const Sphere& s : spheres) rows.push_back({{s.radius, s.mass, s.material, s.fixed}, {s.position, s.velocity}});
    return rows;
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
    return {row_of("spheres", sphere_columns, sphere_rows(scene.spheres)),
            ids_row("sphere_ids", scene.spheres),
            row_of("planes", plane_columns, scene.planes),
            ids_row("plane_ids", scene.planes),
            row_of("materials", material_columns, scene.materials),
            row_of("contacts", contact_columns, scene.contacts)};
}

void read_bodies_row(RecordedRun& run, const BodiesRow& row, const std::string& file)
{
    const auto n = static_cast<std::size_t>(row.count);
    if (row.kind == "spheres") {
        for (const SphereRow& each : unpack<SphereRow>(sphere_columns, row.data, n, file)) {
            run.spheres.push_back(each.sphere);
            run.starts.push_back(each.start);
        }
    }
    if (row.kind == "planes") run.planes = unpack<Plane>(plane_columns, row.data, n, file);
    if (row.kind == "materials") run.materials = unpack<Material>(material_columns, row.data, n, file);
    if (row.kind == "contacts") run.contacts = unpack<ContactRule>(contact_columns, row.data, n, file);
    // Ids are read when somebody asks for one.
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
