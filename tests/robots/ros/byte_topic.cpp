#include "byte_topic.hpp"

#include <dds/ddsi/ddsi_serdata.h>
#include <dds/ddsi/ddsi_sertype.h>
#include <dds/ddsi/q_radmin.h>

#include <algorithm>
#include <cstdio>
#include <cstring>

namespace robots {
namespace {

/// One message as Cyclone keeps it.
struct ByteData : ddsi_serdata {
  ByteData(const ddsi_sertype* sertype, ddsi_serdata_kind data_kind, std::size_t size_in)
      : ddsi_serdata{}, size(size_in), bytes((size_in + 3) / 4 * 4, '\0') {
    ddsi_serdata_init(this, sertype, data_kind);
  }

  std::size_t size;
  std::string bytes;  ///< Cyclone reads up to the next multiple of four
};

const ByteData& bytes_of(const ddsi_serdata* data) {
  return *static_cast<const ByteData*>(data);
}

ddsi_serdata* from_fragments(const ddsi_sertype* type, ddsi_serdata_kind kind, const nn_rdata* fragment,
                             std::size_t size) {
  if (size < 4) return nullptr;
  auto* data = new ByteData(type, kind, size);
  std::size_t filled = 0;
  for (; fragment != nullptr; fragment = fragment->nextfrag) {
    const std::size_t end = std::min<std::size_t>(fragment->maxp1, size);
    if (end <= filled) continue;
    const unsigned char* payload =
        NN_RMSG_PAYLOADOFF(fragment->rmsg, NN_RDATA_PAYLOAD_OFF(fragment)) + (filled - fragment->min);
    std::memcpy(data->bytes.data() + filled, payload, end - filled);
    filled = end;
  }
  return data;
}

ddsi_serdata* from_pieces(const ddsi_sertype* type, ddsi_serdata_kind kind, ddsrt_msg_iovlen_t count,
                          const ddsrt_iovec_t* pieces, std::size_t size) {
  auto* data = new ByteData(type, kind, size);
  std::size_t filled = 0;
  for (ddsrt_msg_iovlen_t i = 0; i < count && filled < size; ++i) {
    const std::size_t length = std::min<std::size_t>(pieces[i].iov_len, size - filled);
    std::memcpy(data->bytes.data() + filled, pieces[i].iov_base, length);
    filled += length;
  }
  return data;
}

/// Without a key, a sample has nothing to tell when only its key is asked for.
ddsi_serdata* from_sample(const ddsi_sertype* type, ddsi_serdata_kind kind, const void* sample) {
  const auto& message = *static_cast<const std::string*>(sample);
  auto* data = new ByteData(type, kind, kind == SDK_KEY ? 0 : message.size());
  std::copy_n(message.data(), data->size, data->bytes.data());
  return data;
}

bool to_sample(const ddsi_serdata* data, void* sample, void**, void*) {
  static_cast<std::string*>(sample)->assign(bytes_of(data).bytes, 0, bytes_of(data).size);
  return true;
}

ddsi_serdata* to_untyped(const ddsi_serdata* data) {
  auto* key = new ByteData(data->type, SDK_KEY, 0);
  key->type = nullptr;
  return key;
}

void copy_out(const ddsi_serdata* data, std::size_t offset, std::size_t size, void* out) {
  std::memcpy(out, bytes_of(data).bytes.data() + offset, size);
}

ddsi_serdata* lend(const ddsi_serdata* data, std::size_t offset, std::size_t size, ddsrt_iovec_t* out) {
  out->iov_base = const_cast<char*>(bytes_of(data).bytes.data()) + offset;
  out->iov_len = static_cast<ddsrt_iov_len_t>(size);
  return ddsi_serdata_ref(data);
}

ddsi_serdata_ops make_data_operations() {
  ddsi_serdata_ops operations{};
  operations.eqkey = [](const ddsi_serdata*, const ddsi_serdata*) { return true; };
  operations.get_size = [](const ddsi_serdata* data) {
    return static_cast<std::uint32_t>(bytes_of(data).size);
  };
  operations.from_ser = from_fragments;
  operations.from_ser_iov = from_pieces;
  operations.from_keyhash = [](const ddsi_sertype* type, const ddsi_keyhash*) -> ddsi_serdata* {
    return new ByteData(type, SDK_KEY, 0);
  };
  operations.from_sample = from_sample;
  operations.to_ser = copy_out;
  operations.to_ser_ref = lend;
  operations.to_ser_unref = [](ddsi_serdata* data, const ddsrt_iovec_t*) { ddsi_serdata_unref(data); };
  operations.to_sample = to_sample;
  operations.to_untyped = to_untyped;
  operations.untyped_to_sample = [](const ddsi_sertype*, const ddsi_serdata*, void*, void**, void*) {
    return true;
  };
  operations.free = [](ddsi_serdata* data) { delete static_cast<ByteData*>(data); };
  operations.print = [](const ddsi_sertype*, const ddsi_serdata*, char* text, std::size_t size) {
    return static_cast<std::size_t>(std::snprintf(text, size, "bytes"));
  };
  operations.get_keyhash = [](const ddsi_serdata*, ddsi_keyhash* hash, bool) {
    std::memset(hash, 0, sizeof *hash);
  };
  return operations;
}

/// No type information: topics match by their names, as those of ROS 2 do. Samples are never lent, so nothing
/// allocates any.
ddsi_sertype_ops make_type_operations() {
  ddsi_sertype_ops operations{};
  operations.version = ddsi_sertype_v0;
  operations.free = [](ddsi_sertype* type) {
    ddsi_sertype_fini(type);
    delete type;
  };
  operations.zero_samples = [](const ddsi_sertype*, void*, std::size_t) {};
  operations.realloc_samples = [](void**, const ddsi_sertype*, void*, std::size_t, std::size_t) {};
  operations.free_samples = [](const ddsi_sertype*, void**, std::size_t, dds_free_op_t) {};
  operations.equal = [](const ddsi_sertype*, const ddsi_sertype*) { return true; };
  operations.hash = [](const ddsi_sertype*) -> std::uint32_t { return 0; };
  return operations;
}

}  // namespace

dds_entity_t create_byte_topic(dds_entity_t participant, const std::string& topic, const std::string& type) {
  static const ddsi_serdata_ops kDataOperations = make_data_operations();
  static const ddsi_sertype_ops kTypeOperations = make_type_operations();
  auto* sertype = new ddsi_sertype{};
  ddsi_sertype_init(sertype, type.c_str(), &kTypeOperations, &kDataOperations, true);
  sertype->allowed_data_representation = DDS_DATA_REPRESENTATION_FLAG_XCDR1;
  const dds_entity_t entity =
      dds_create_topic_sertype(participant, topic.c_str(), &sertype, nullptr, nullptr, nullptr);
  if (entity < 0) ddsi_sertype_unref(sertype);
  return entity;
}

}  // namespace robots
