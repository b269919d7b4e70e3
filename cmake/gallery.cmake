# The gallery's files, as the program carries them: entries, case files, and the data that these read.
file(GLOB shelf RELATIVE ${PROJECT_SOURCE_DIR} CONFIGURE_DEPENDS gallery/entries/*.yaml gallery/cases/*.yaml
  gallery/cases/data/* cases/*.yaml cases/data/*)
list(SORT shelf)
embed_table(plunge_gallery gallery_shelf "gallery/shelf.h" gallery_shelf_file ${shelf})

# Its page.
embed(plunge_gallery gallery_page_template gallery/page/template.html)
embed(plunge_gallery gallery_page_style compare/page/style.css gallery/page/gallery.css)
embed(plunge_gallery gallery_page_script gallery/page/gallery.js)
