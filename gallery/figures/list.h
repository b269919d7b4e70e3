/* The kinds of figures, in the order in which they are listed. */
#pragma once

#define GALLERY_DRAWERS(X) X(graph) X(theory) X(snapshots) X(table)
