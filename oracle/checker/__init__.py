"""The checker of certificates (docs/certificates.md)."""
