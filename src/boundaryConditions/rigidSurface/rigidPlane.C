/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Class
    Foam::rigidPlane

Description
    g = (x - p).n
\*---------------------------------------------------------------------------*/

#include "rigidSurface.H"
#include "unknownEntries.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{

class rigidPlane
:
    public rigidSurface
{
    point point_;
    vector normal_;

public:

    TypeName("plane");

    explicit rigidPlane(const dictionary& dict)
    :
        point_(dict.get<point>("point")),
        normal_(readDirection("normal", dict))
    {
        reportUnknownEntries(dict, {"type", "point", "normal"});
    }

    virtual autoPtr<rigidSurface> clone() const { return autoPtr<rigidSurface>(new rigidPlane(*this)); }

    virtual distance at(const point& x) const { return {(x - point_) & normal_, normal_, Zero}; }

    virtual bool isAlong(const vector& direction) const { return mag(normal_ & direction) < 1e-10; }
};

defineTypeNameAndDebug(rigidPlane, 0);
addToRunTimeSelectionTable(rigidSurface, rigidPlane, dictionary);

} // End namespace Foam


// ************************************************************************* //
