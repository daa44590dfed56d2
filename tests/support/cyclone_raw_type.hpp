#pragma once
/// For Cyclone DDS: a type that is a name and bytes, as ROS messages are on the network. No IDL, no generated
/// code.

#include <dds/dds.h>
#include <dds/ddsi/ddsi_serdata.h>
#include <dds/ddsi/ddsi_sertype.h>
#include <dds/ddsi/q_radmin.h>

#include <cstddef>
#include <cstdio>
#include <cstring>
#include <new>
#include <string_view>

namespace aisle::cyclone {

/// One message, its bytes with those of encapsulation behind it in the same allocation.
struct RawData {
  ddsi_serdata c;
  std::size_t size;

  char* bytes() { return reinterpret_cast<char*>(this + 1); }
  const char* bytes() const { return reinterpret_cast<const char*>(this + 1); }
};

inline const RawData& raw(const ddsi_serdata* data) {
  return *reinterpret_cast<const RawData*>(data);
}

inline std::string_view bytes_of(const ddsi_serdata* data) {
  return {raw(data).bytes(), raw(data).size};
}

/// Cyclone may read up to the next multiple of four bytes.
inline RawData* make_raw(const ddsi_sertype* type, ddsi_serdata_kind kind, std::size_t size) {
  auto* data = static_cast<RawData*>(::operator new(sizeof(RawData) + size + 4));
  ddsi_serdata_init(&data->c, type, kind);
  data->size = size;
  std::memset(data->bytes() + size, 0, 4);
  return data;
}

inline ddsi_serdata* from_fragments(const ddsi_sertype* type, ddsi_serdata_kind kind,
                                    const nn_rdata* fragment, std::size_t size) {
  RawData* data = make_raw(type, kind, size);
  std::uint32_t have = 0;
  for (; fragment != nullptr; fragment = fragment->nextfrag) {
    if (fragment->maxp1 <= have) continue;
    const unsigned char* payload = NN_RMSG_PAYLOADOFF(fragment->rmsg, NN_RDATA_PAYLOAD_OFF(fragment));
    std::memcpy(data->bytes() + have, payload + have - fragment->min, fragment->maxp1 - have);
    have = fragment->maxp1;
  }
  return &data->c;
}

inline ddsi_serdata* from_pieces(const ddsi_sertype* type, ddsi_serdata_kind kind, ddsrt_msg_iovlen_t pieces,
                                 const ddsrt_iovec_t* piece, std::size_t size) {
  RawData* data = make_raw(type, kind, size);
  std::size_t have = 0;
  for (ddsrt_msg_iovlen_t i = 0; i < pieces && have < size; ++i) {
    const std::size_t more = piece[i].iov_len < size - have ? piece[i].iov_len : size - have;
    std::memcpy(data->bytes() + have, piece[i].iov_base, more);
    have += more;
  }
  return &data->c;
}

/// @param sample a std::string_view
inline ddsi_serdata* from_sample(const ddsi_sertype* type, ddsi_serdata_kind kind, const void* sample) {
  const auto message = kind == SDK_KEY ? std::string_view() : *static_cast<const std::string_view*>(sample);
  RawData* data = make_raw(type, kind, message.size());
  std::memcpy(data->bytes(), message.data(), message.size());
  return &data->c;
}

inline ddsi_serdata* to_bytes_ref(const ddsi_serdata* data, std::size_t offset, std::size_t size,
                                  ddsrt_iovec_t* ref) {
  ref->iov_base = const_cast<char*>(raw(data).bytes()) + offset;
  ref->iov_len = size;
  return ddsi_serdata_ref(data);
}

inline ddsi_serdata* to_untyped(const ddsi_serdata* data) {
  RawData* untyped = make_raw(data->type, SDK_KEY, 0);
  untyped->c.type = nullptr;
  return &untyped->c;
}

inline const ddsi_serdata_ops& data_operations() {
  static const ddsi_serdata_ops operations = [] {
    ddsi_serdata_ops ops{};
    ops.eqkey = [](const ddsi_serdata*, const ddsi_serdata*) { return true; };
    ops.get_size = [](const ddsi_serdata* data) { return static_cast<std::uint32_t>(raw(data).size); };
    ops.from_ser = from_fragments;
    ops.from_ser_iov = from_pieces;
    ops.from_keyhash = [](const ddsi_sertype* type, const ddsi_keyhash*) {
      return &make_raw(type, SDK_KEY, 0)->c;
    };
    ops.from_sample = from_sample;
    ops.to_ser = [](const ddsi_serdata* data, std::size_t offset, std::size_t size, void* to) {
      std::memcpy(to, raw(data).bytes() + offset, size);
    };
    ops.to_ser_ref = to_bytes_ref;
    ops.to_ser_unref = [](ddsi_serdata* data, const ddsrt_iovec_t*) { ddsi_serdata_unref(data); };
    // Messages are taken as bytes (dds_takecdr), never as samples.
    ops.to_sample = [](const ddsi_serdata*, void*, void**, void*) { return false; };
    ops.to_untyped = to_untyped;
    ops.untyped_to_sample = [](const ddsi_sertype*, const ddsi_serdata*, void*, void**, void*) {
      return false;
    };
    ops.free = [](ddsi_serdata* data) { ::operator delete(data); };
    ops.print = [](const ddsi_sertype*, const ddsi_serdata*, char* text, std::size_t size) {
      return static_cast<std::size_t>(std::snprintf(text, size, "(bytes)"));
    };
    ops.get_keyhash = [](const ddsi_serdata*, ddsi_keyhash* hash, bool) {
      std::memset(hash, 0, sizeof *hash);
    };
    return ops;
  }();
  return operations;
}

/// Without type_id, type_map and type_info: types match by their names alone, as those of ROS do.
inline const ddsi_sertype_ops& type_operations() {
  static const ddsi_sertype_ops operations = [] {
    ddsi_sertype_ops ops{};
    ops.version = ddsi_sertype_v0;
    ops.free = [](ddsi_sertype* type) {
      ddsi_sertype_fini(type);
      delete type;
    };
    ops.zero_samples = [](const ddsi_sertype*, void*, std::size_t) {};
    ops.realloc_samples = [](void**, const ddsi_sertype*, void*, std::size_t, std::size_t) {};
    ops.free_samples = [](const ddsi_sertype*, void**, std::size_t, dds_free_op_t) {};
    ops.equal = [](const ddsi_sertype*, const ddsi_sertype*) { return true; };
    ops.hash = [](const ddsi_sertype*) { return 0U; };
    return ops;
  }();
  return operations;
}

/// @param name, type  as DDS says them; @return negative on failure
inline dds_entity_t raw_topic(dds_entity_t participant, const char* name, const char* type) {
  auto* made = new ddsi_sertype{};
  ddsi_sertype_init(made, type, &type_operations(), &data_operations(), true);
  made->allowed_data_representation = DDS_DATA_REPRESENTATION_FLAG_XCDR1;
  ddsi_sertype* given = made;
  const dds_entity_t topic = dds_create_topic_sertype(participant, name, &given, nullptr, nullptr, nullptr);
  if (topic < 0) ddsi_sertype_unref(made);
  return topic;
}

}  // namespace aisle::cyclone
