# Manual pages and completions, which the program writes itself from its own definitions.
install(CODE "
  set(root \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}\")
  function(write_with_sturm file)
    get_filename_component(folder \"\${root}/\${file}\" DIRECTORY)
    file(MAKE_DIRECTORY \"\${folder}\")
    execute_process(COMMAND \"$<TARGET_FILE:sturm>\" \${ARGN} OUTPUT_FILE \"\${root}/\${file}\" COMMAND_ERROR_IS_FATAL ANY)
    message(STATUS \"Installing: \${root}/\${file}\")
  endfunction()
  write_with_sturm(${CMAKE_INSTALL_DATADIR}/bash-completion/completions/sturm completion bash)
  write_with_sturm(${CMAKE_INSTALL_DATADIR}/zsh/site-functions/_sturm completion zsh)
  write_with_sturm(${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d/sturm.fish completion fish)
  execute_process(COMMAND \"$<TARGET_FILE:sturm>\" man --folder \"\${root}/${CMAKE_INSTALL_MANDIR}/man1\" COMMAND_ERROR_IS_FATAL ANY)
")
