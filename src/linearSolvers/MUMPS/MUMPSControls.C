/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "MUMPSControls.H"
#include "blasThreads.H"
#include "ListOps.H"
#include "unknownEntries.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

const Foam::Enum<Foam::MUMPSControls::orderings>
Foam::MUMPSControls::orderingNames
({
    { orderings::METIS, "METIS" },
    { orderings::AUTOMATIC, "automatic" },
});


namespace Foam
{

//- Read a value and check that it is in a range
template<class Type>
static Type readInRange
(
    const dictionary& dict,
    const word& keyword,
    const Type deflt,
    const Type low,
    const Type high
)
{
    const Type value = dict.getOrDefault<Type>(keyword, deflt);

    if (value < low || value > high)
    {
        FatalIOErrorInFunction(dict)
            << keyword << ' ' << value << " is not valid: choose "
            << low << " to " << high << exit(FatalIOError);
    }

    return value;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::MUMPSControls::MUMPSControls(const dictionary& dict)
:
    ordering(orderingNames.getOrDefault("ordering", dict, orderings::METIS)),
    memoryRelaxation
    (
        readInRange<label>(dict, "memoryRelaxation", 30, -99, 100000)
    ),
    maxMemory(readInRange<label>(dict, "maxMemory", 0, 0, labelMax)),
    blockLowRank(readInRange<scalar>(dict, "blockLowRank", 0, 0, 1)),
    scaling(dict.getOrDefault<label>("scaling", 77)),
    pivotThreshold(readInRange<scalar>(dict, "pivotThreshold", 0.01, 0, 1)),
    threads
    (
        readInRange<label>(dict, "threads", blasThreads::nDefault(), 1, 1024)
    ),
    ICNTL(dict.getOrDefault<List<Tuple2<label, label>>>("ICNTL", {}))
{
    // maxIter is for those who solve with old factors
    reportUnknownEntries
    (
        dict,
        {
            "type", "maxIter", "ordering", "memoryRelaxation", "maxMemory",
            "blockLowRank", "scaling", "pivotThreshold", "threads", "ICNTL"
        }
    );

    const labelList scalings({0, 7, 8, 77});
    if (!scalings.found(scaling))
    {
        FatalIOErrorInFunction(dict)
            << "scaling " << scaling << " is not valid: choose one of "
            << flatOutput(scalings) << exit(FatalIOError);
    }

    const labelList reserved({5, 7, 14, 18, 19, 20, 21, 23, 24});
    for (const auto& c : ICNTL)
    {
        if (c.first() < 1 || c.first() > 60 || reserved.found(c.first()))
        {
            FatalIOErrorInFunction(dict)
                << "ICNTL(" << c.first() << ") is not valid: choose 1 to 60 "
                << "but not one of " << flatOutput(reserved)
                << exit(FatalIOError);
        }
    }
}


// ************************************************************************* //
