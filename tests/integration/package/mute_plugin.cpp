// A shared library that is no plug-in: it registers nothing.
extern "C" void nothing() {}
