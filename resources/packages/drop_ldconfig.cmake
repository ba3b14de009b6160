# Run by cpack on the packages that it has made. To libraries it adds scripts that call ldconfig, which policy 8.1.1 leaves to
# the trigger that the package has, and it has no option against them.
foreach(package IN LISTS CPACK_PACKAGE_FILES)
  if(NOT package MATCHES "/libviscera0_[^/]*\\.deb$")
    continue()
  endif()
  set(tree "${package}.tree")
  execute_process(COMMAND dpkg-deb --raw-extract "${package}" "${tree}" COMMAND_ERROR_IS_FATAL ANY)
  file(REMOVE "${tree}/DEBIAN/postinst" "${tree}/DEBIAN/postrm")
  execute_process(COMMAND dpkg-deb --root-owner-group -Z${CPACK_DEBIAN_COMPRESSION_TYPE} --build "${tree}" "${package}"
    COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
  file(REMOVE_RECURSE "${tree}")
endforeach()
