#include <carom/io.hpp>

#include "io/recording_chunks.hpp"

#include <new>

namespace carom {

namespace io {

namespace {

/// A process that was killed while it wrote a chunk leaves a journal: opening the file for writing takes that chunk
/// back.
void recover(const std::filesystem::path& file)
{
    std::error_code none;
    if (std::filesystem::file_size(file.string() + "-journal", none) == 0 || none) return;
    Database(file, Access::recover).text_of("SELECT count(*) FROM sqlite_schema");
}

}  // namespace

}  // namespace io

using namespace io;

class RecordingReader::Implementation {
public:
    explicit Implementation(const std::filesystem::path& file) : database((recover(file), file), Access::read)
    {
        read_safely([&] {
            head = read_head(database);
            chunks.emplace(database, head);
        });
    }

    /// A length that makes no sense may ask for more memory than there is.
    template <class Read>
    void read_safely(const Read& read)
    {
        try {
            read();
        } catch (const std::bad_alloc&) {
            damaged(database.file, "sizes beyond all memory");
        } catch (const std::length_error&) {
            damaged(database.file, "sizes beyond all memory");
        }
    }

    Database database;
    RecordingHead head;
    std::optional<ChunkReader> chunks;
};

RecordingReader::RecordingReader(const std::filesystem::path& file)
{
    if (!std::filesystem::is_regular_file(file)) throw InputError({file.string() + ": no such file"});
    implementation_ = std::make_unique<Implementation>(file);
}

RecordingReader::~RecordingReader() = default;

const RecordedRun& RecordingReader::run() const
{
    return implementation_->head.run;
}

bool RecordingReader::next(Instant& instant)
{
    bool more = false;
    implementation_->read_safely([&] { more = implementation_->chunks->next(instant); });
    return more;
}

void RecordingReader::forget_starts()
{
    implementation_->head.run.starts = {};
}

const std::map<std::string, std::string>& RecordingReader::meta() const
{
    return implementation_->head.meta;
}

const std::string& RecordingReader::scene() const
{
    return implementation_->head.scene;
}

std::string RecordingReader::body_name(BodyId body) const
{
    std::string name;
    implementation_->read_safely(
        [&] { name = read_body_name(implementation_->database, implementation_->head.run, body); });
    return name;
}

std::filesystem::path find_recording(const std::filesystem::path& what)
{
    if (std::filesystem::is_regular_file(what)) return what;
    const std::filesystem::path inside = what / recording_name;
    if (std::filesystem::is_regular_file(inside)) return inside;
    throw InputError(
        {what.string() +
         ": no recording there (carom run SCENE -o DIR makes one of the event method; discrete methods have none)"});
}

}  // namespace carom
