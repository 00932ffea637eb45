# What `cmake --install` and the Debian package (`./dev package`) consist of. Programs look for
# examples and templates in ../share/roverstudio beside themselves.
include(GNUInstallDirs)
install(TARGETS roversim)
install(DIRECTORY assets/ DESTINATION ${CMAKE_INSTALL_DATADIR}/roverstudio PATTERN icons EXCLUDE)
# The window opens it, so it is no mere documentation, which systems may leave out.
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DATADIR}/roverstudio PATTERN *.py EXCLUDE)
install(FILES README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/roverstudio)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/roverstudio RENAME copyright)
set(package "${CMAKE_CURRENT_SOURCE_DIR}/cmake/package")
install(FILES ${package}/roversim.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
if(ROVER_BUILD_GUI)
    install(TARGETS roverstudio)
    install(FILES ${package}/roverstudio.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
    install(FILES ${package}/roverstudio.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
    install(FILES ${package}/roverstudio-mime.xml
        DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages RENAME roverstudio.xml)
    install(FILES assets/icons/roverstudio.svg
        DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME roverstudio)
set(CPACK_PACKAGE_VENDOR RoverStudio)
set(CPACK_PACKAGE_CONTACT "the RoverStudio team <roverstudio@example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Design wheeled rovers with passive suspension")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)  # the libraries that the programs are linked with
set(CPACK_DEBIAN_PACKAGE_DEPENDS libgl1-mesa-dri)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS ffmpeg)
include(CPack)
