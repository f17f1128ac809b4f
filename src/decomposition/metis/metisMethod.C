/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "metisMethod.H"
#include "partition.H"
#include "regionGraph.H"
#include "Time.H"
#include "IOdictionary.H"
#include "Enum.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(metisMethod, 0);

    // These replace an entry of the same name
    addRemovableToRunTimeSelectionTable(decompositionMethod, metisMethod, dictionary);
    addRemovableToRunTimeSelectionTable(decompositionMethod, metisMethod, dictionaryRegion);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::metisMethod::read()
{
    const Enum<int> choices{{0, "apart"}, {1, "together"}};
    together_ = choices.getOrDefault("interfaces", coeffsDict_, 0);
    regionWeights_ = coeffsDict_.subOrEmptyDict("regionWeights");

    if (!coeffsDict_.readIfPresent("processorWeights", processorWeights_)) return;

    const scalar total = sum(processorWeights_);
    if (processorWeights_.size() != nDomains_ || min(processorWeights_) <= 0)
    {
        FatalIOErrorInFunction(coeffsDict_)
            << "processorWeights " << processorWeights_ << ", expected "
            << nDomains_ << " numbers > 0, one for each subdomain"
            << exit(FatalIOError);
    }
    for (scalar& w : processorWeights_) w /= total;
}


void Foam::metisMethod::checkAgreement
(
    const polyMesh& mesh,
    const wordList& regions
) const
{
    // Each region has a dictionary of its own, unless all were given one
    const fileName own(mesh.time().system()/mesh.name()/"decomposeParDict");
    for (const word& region : regions)
    {
        dictionary other(decompDict_);
        if (decompDict_.name().endsWith(own))
        {
            other = IOdictionary
            (
                IOobject
                (
                    "decomposeParDict", mesh.time().system(), region, mesh.time(),
                    IOobject::MUST_READ, IOobject::NO_WRITE, false
                )
            );
        }
        const word method(other.get<word>("method"));
        const label n = nDomains(other, region);
        if
        (
            n == nDomains_ && method == decompDict_.get<word>("method")
         && findCoeffsDict(other, "metisCoeffs", selectionType::NULL_DICT) == coeffsDict_
        ) continue;

        FatalIOErrorInFunction(decompDict_)
            << "Regions " << flatOutput(regions) << " are decomposed together,"
            << " but the dictionaries of " << mesh.name() << " (method "
            << typeName << ", " << nDomains_ << " subdomains) and " << region
            << " (method " << method << ", " << n << " subdomains) differ." << nl
            << "Expected the same numberOfSubdomains, method and metisCoeffs"
            << exit(FatalIOError);
    }
}


void Foam::metisMethod::checkParts(const labelUList& part) const
{
    const labelList sizes(partSizes(part, nDomains_));
    if (!sizes.found(0)) return;
    FatalIOErrorInFunction(decompDict_)
        << "Subdomains " << flatOutput(findIndices(sizes, 0)) << " of " << nDomains_
        << " are without cells: there are " << part.size() << " cells, those"
        << " at an interface counted once. Expected fewer subdomains"
        << exit(FatalIOError);
}


Foam::labelList Foam::metisMethod::decomposeTogether(const polyMesh& mesh) const
{
    if (Pstream::parRun())
    {
        FatalIOErrorInFunction(coeffsDict_)
            << "Regions are decomposed together from one rank only: use"
            << " decomposePar, or interfaces apart" << exit(FatalIOError);
    }
    if (decompDict_.found("weightField"))
    {
        FatalIOErrorInFunction(decompDict_)
            << "weightField " << decompDict_.get<word>("weightField")
            << " of region " << mesh.name() << " where regions are decomposed"
            << " together, expected regionWeights in metisCoeffs"
            << exit(FatalIOError);
    }
    const regionGraph graph(mesh, regionWeights_);
    checkAgreement(mesh, graph.regions());

    const labelList part
    (
        partition(graph.start(), graph.neighbour(), graph.weight(), nDomains_, processorWeights_)
    );
    checkParts(part);
    return labelList(UIndirectList<label>(part, graph.vertex(mesh.name())));
}


Foam::label Foam::metisMethod::decomposeSerial
(
    const labelList& neighbour,
    const labelList& start,
    const List<scalar>& weight,
    labelList& part
) const
{
    const label n = start.size() - 1;
    const scalarList ones(weight.empty() ? n : 0, scalar(1));
    part = partition(start, neighbour, weight.empty() ? ones : weight, nDomains_, processorWeights_);
    checkParts(part);
    return 0;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::metisMethod::metisMethod(const dictionary& decompDict)
:
    metisLikeDecomp(typeName, decompDict)
{
    read();
}


Foam::metisMethod::metisMethod(const dictionary& decompDict, const word& region)
:
    metisLikeDecomp(typeName, decompDict, region)
{
    read();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::labelList Foam::metisMethod::decompose
(
    const polyMesh& mesh,
    const pointField& cellCentres,
    const scalarField& weights
) const
{
    if (together_) return decomposeTogether(mesh);
    return metisLikeDecomp::decompose(mesh, cellCentres, weights);
}


Foam::labelList Foam::metisMethod::decompose
(
    const polyMesh& mesh,
    const labelList& cluster,
    const pointField& clusterCentres,
    const scalarField& weights
) const
{
    if (together_)
    {
        FatalIOErrorInFunction(coeffsDict_)
            << "Decomposition constraints where regions are decomposed together;"
            << " expected interfaces apart, or no constraints" << exit(FatalIOError);
    }
    return metisLikeDecomp::decompose(mesh, cluster, clusterCentres, weights);
}


// ************************************************************************* //
