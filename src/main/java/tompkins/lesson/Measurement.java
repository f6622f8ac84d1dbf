package tompkins.lesson;

/** What a lesson can measure in a picture: readings of rays, and numbers made from them. */
public sealed interface Measurement
        permits RayReading,
                AngleBetween,
                CircleRadius,
                LensSpread,
                StarCount,
                DifferenceOf,
                RatioOf,
                WithNumber,
                WithShutter,
                OnRide {}
