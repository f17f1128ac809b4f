/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "remeshMemory.H"
#include "points0MotionSolver.H"
#include "unknownEntries.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Mean length of the edges at the vertices of the reference
static scalarField meanEdges(const feMesh& fe)
{
    scalarField sum(fe.nNodes(), 0), n(sum);
    for (const elementBlock& block : fe.blocks()) withElement(block, [&](auto tag)
    {
        typedef decltype(tag) E;
        for (label e = 0; e < block.size(); ++e) for (const auto& edge : E::edges)
        {
            const label a = block.element(e)[edge[0]], b = block.element(e)[edge[1]];
            const scalar l = mag(fe.points()[b] - fe.points()[a]);
            for (const label v : {a, b})
            {
                sum[v] += l;
                n[v] += 1;
            }
        }
    });
    fe.copies().sum(sum);
    fe.copies().sum(n);
    return sum/max(n, scalar(1));
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Object>
bool Foam::remeshMemory::exact<Object>::writeObject
(
    IOstream::streamFormat format,
    IOstream::versionNumber version,
    IOstream::compressionType compression,
    const bool valid
) const
{
    const unsigned digits = IOstream::defaultPrecision(17);
    const bool ok = Object::writeObject(format, version, compression, valid);
    IOstream::defaultPrecision(digits);
    return ok;
}


Foam::IOobject Foam::remeshMemory::sizesIO(const IOobject::readOption read) const
{
    return IOobject("remeshSize", region_.mesh().time().timeName(), region_.mesh(), read, IOobject::AUTO_WRITE);
}


void Foam::remeshMemory::makeSizes(const dictionary& dict)
{
    scalarField size(meanEdges(region_.fe()));
    size *= dict.getOrDefault<scalar>("factor", 1);
    const scalar least = dict.getOrDefault<scalar>("min", 0), most = dict.getOrDefault<scalar>("max", GREAT);
    for (scalar& s : size) s = min(max(s, least), most);
    sizes_.reset
    (
        new exact<pointScalarField>
        (
            sizesIO(IOobject::NO_READ), pointMesh::New(region_.mesh()), dimensionedScalar(dimLength, Zero)
        )
    );
    setSizes(size);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::remeshMemory::remeshMemory(const feRegion& region, const dictionary& size)
:
    region_(region)
{
    reportUnknownEntries(size, {"factor", "min", "max"});
    const IOobject points0(points0MotionSolver::points0IO(region_.mesh()));
    const bool exchanged =
        points0.name() == "points0" && points0.instance() != region_.mesh().time().constant();
    if (exchanged) setPoints0(pointIOField(points0));

    IOobject io(sizesIO(IOobject::MUST_READ));
    if (returnReduce(io.typeHeaderOk<pointScalarField>(), andOp<bool>()))
    {
        sizes_.reset(new exact<pointScalarField>(io, pointMesh::New(region_.mesh())));
        return;
    }
    if (exchanged)
    {
        WarningInFunction
            << "The mesh of region " << region_.name() << " has been exchanged, but there is no "
            << io.objectPath() << ": its cells have the sizes that are wanted" << endl;
    }
    makeSizes(size);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalarField Foam::remeshMemory::sizes() const
{
    scalarField s(region_.fe().nVertices());
    forAll(s, n) s[n] = size(n);
    return s;
}


void Foam::remeshMemory::setSizes(const scalarField& size)
{
    region_.fe().toPoints<scalar>(size, sizes_->primitiveFieldRef());
}


void Foam::remeshMemory::setPoints0(const pointField& points0)
{
    points0_.clear();
    points0_.reset
    (
        new exact<pointIOField>
        (
            IOobject
            (
                "points0", region_.mesh().time().timeName(), polyMesh::meshSubDir, region_.mesh(),
                IOobject::NO_READ, IOobject::AUTO_WRITE
            ),
            points0
        )
    );
}


// ************************************************************************* //
