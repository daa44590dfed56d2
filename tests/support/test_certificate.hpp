#pragma once
/// Self-signed certificates for tests, generated on the spot and valid for an hour.

#include <openssl/evp.h>
#include <openssl/pem.h>
#include <openssl/x509.h>
#include <openssl/x509v3.h>

#include <memory>
#include <stdexcept>
#include <string>

namespace aisle {

struct TestCertificate {
  std::string certificate_pem;
  std::string key_pem;
};

namespace test_certificate_parts {

template <auto Free>
struct Freed {
  template <class T>
  void operator()(T* thing) const {
    Free(thing);
  }
};
using Key = std::unique_ptr<EVP_PKEY, Freed<EVP_PKEY_free>>;
using Certificate = std::unique_ptr<X509, Freed<X509_free>>;
using Memory = std::unique_ptr<BIO, Freed<BIO_free_all>>;

inline std::string text_of(BIO* memory) {
  const char* data = nullptr;
  const long length = BIO_ctrl(memory, BIO_CTRL_INFO, 0, &data);
  return {data, static_cast<std::size_t>(length)};
}

inline Certificate self_signed(EVP_PKEY* key) {
  constexpr long kLifetime_s = 3600;
  Certificate certificate(X509_new());
  X509_set_version(certificate.get(), X509_VERSION_3);
  ASN1_INTEGER_set(X509_get_serialNumber(certificate.get()), 1);
  X509_gmtime_adj(X509_getm_notBefore(certificate.get()), -kLifetime_s);
  X509_gmtime_adj(X509_getm_notAfter(certificate.get()), kLifetime_s);
  X509_set_pubkey(certificate.get(), key);
  X509_NAME* name = X509_get_subject_name(certificate.get());
  const unsigned char host[] = "localhost";
  X509_NAME_add_entry_by_txt(name, "CN", MBSTRING_ASC, host, -1, -1, 0);
  X509_set_issuer_name(certificate.get(), name);
  if (X509_sign(certificate.get(), key, EVP_sha256()) == 0) throw std::runtime_error("not signed");
  return certificate;
}

}  // namespace test_certificate_parts

/// @param pass_phrase  empty: the key is not protected
inline TestCertificate make_certificate(const std::string& pass_phrase = {}) {
  namespace parts = test_certificate_parts;
  const parts::Key key(EVP_EC_gen("P-256"));
  const parts::Certificate certificate = parts::self_signed(key.get());
  const parts::Memory certificate_pem(BIO_new(BIO_s_mem()));
  const parts::Memory key_pem(BIO_new(BIO_s_mem()));
  PEM_write_bio_X509(certificate_pem.get(), certificate.get());
  PEM_write_bio_PKCS8PrivateKey(key_pem.get(), key.get(), pass_phrase.empty() ? nullptr : EVP_aes_128_cbc(),
                                pass_phrase.data(), static_cast<int>(pass_phrase.size()), nullptr, nullptr);
  return {parts::text_of(certificate_pem.get()), parts::text_of(key_pem.get())};
}

}  // namespace aisle
