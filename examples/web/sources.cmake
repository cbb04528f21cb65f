# What the page's module is made of, beside the scripted hands: for WebAssembly and for its native twin.
set(VBSS_WEB_SOURCES
  ${CMAKE_CURRENT_LIST_DIR}/page.c ${CMAKE_CURRENT_LIST_DIR}/picture.c ${CMAKE_CURRENT_LIST_DIR}/state.c
  ${CMAKE_CURRENT_LIST_DIR}/tracked.c ${CMAKE_CURRENT_LIST_DIR}/../report/stage.c ${CMAKE_CURRENT_LIST_DIR}/../trainer/grip.c
  ${CMAKE_CURRENT_LIST_DIR}/../viewer/camera.c ${CMAKE_CURRENT_LIST_DIR}/../viewer/live.c
  ${CMAKE_CURRENT_LIST_DIR}/../viewer/live_view.c
  ${CMAKE_CURRENT_LIST_DIR}/../viewer/mouse_hand.c
  ${CMAKE_CURRENT_LIST_DIR}/../ghost/ghost.c ${CMAKE_CURRENT_LIST_DIR}/../ghost/observe.c ${CMAKE_CURRENT_LIST_DIR}/../ghost/track.c
  ${CMAKE_CURRENT_LIST_DIR}/../exercise/practice.c ${CMAKE_CURRENT_LIST_DIR}/../exercise/starts.c
  ${CMAKE_CURRENT_LIST_DIR}/ghosts.c ${CMAKE_CURRENT_LIST_DIR}/practised.c ${CMAKE_CURRENT_LIST_DIR}/replayed.c ${CMAKE_CURRENT_LIST_DIR}/../viewer/player.c)
