// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef seeds_ColorBands_h
#define seeds_ColorBands_h

class vtkSMProxy;

/**
 * The bands of a colour map (a proxy PVLookupTable): from 0 upwards each has one colour and the
 * same width. They are the map's own discrete colours, so state files keep them and its legend
 * shows them.
 */
namespace seeds::bands
{

/** More bands than this are a smooth map: ParaView's own has 256 colours. */
constexpr int Most = 255;

/** The width that gives 5 to 10 bands up to a value, 1, 2 or 5 times a power of 10. */
double roundSpacing(double largest);
/** The number of bands of a width that reach up to a value. */
double numberOf(double spacing, double largest);

/** The width of a map's bands; 0 where it is smooth. */
double spacingOf(vtkSMProxy* map);
/**
 * Gives a map bands of a width, so many that they reach up to @p largest. Returns whether that
 * changed the map. At most Most bands.
 */
bool set(vtkSMProxy* map, double spacing, double largest);
/** Has a map's legend (a proxy ScalarBarWidgetRepresentation) name the borders of its bands. */
void label(vtkSMProxy* legend, vtkSMProxy* map);
/** Makes a map smooth again, over the range of what is coloured by it. */
void clear(vtkSMProxy* map);

}

#endif
