/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Class
    Foam::rigidCylinder

Description
    g = r - R with the way r from the axis, of a solid inside R - r
\*---------------------------------------------------------------------------*/

#include "rigidSurface.H"
#include "unknownEntries.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{

class rigidCylinder
:
    public rigidSurface
{
    point point_;
    vector axis_;
    scalar radius_, side_;

public:

    TypeName("cylinder");

    explicit rigidCylinder(const dictionary& dict)
    :
        point_(dict.get<point>("point")),
        axis_(readDirection("axis", dict)),
        radius_(readRadius(dict)),
        side_(readSide(dict))
    {
        reportUnknownEntries(dict, {"type", "point", "axis", "radius", "side"});
    }

    virtual autoPtr<rigidSurface> clone() const { return autoPtr<rigidSurface>(new rigidCylinder(*this)); }

    virtual distance at(const point& x) const
    {
        return round(x - point_, symmTensor(symmTensor::I) - sqr(axis_), radius_, side_);
    }

    virtual bool isAlong(const vector& direction) const { return mag(axis_ ^ direction) < 1e-10; }
};

defineTypeNameAndDebug(rigidCylinder, 0);
addToRunTimeSelectionTable(rigidSurface, rigidCylinder, dictionary);

} // End namespace Foam


// ************************************************************************* //
