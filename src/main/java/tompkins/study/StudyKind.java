package tompkins.study;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** The studies that the program can make. */
public enum StudyKind {

    /** See {@link ApertureStudy}. */
    APERTURE {
        @Override
        public Study study(StudySetup setup) {
            Map<String, SamplingMethod.Factory> methods = new LinkedHashMap<>();
            for (SamplingMethod method : SamplingMethod.values()) {
                methods.put(method.title(), method::pattern);
            }
            return new ApertureStudy(
                    setup.studios(List.of("fig3a", "fig3b")),
                    setup.seed(),
                    4096,
                    5,
                    methods,
                    SamplingMethod.SOBOL.title());
        }
    },

    /** See {@link AntialiasingStudy}. */
    ANTIALIASING {
        @Override
        public Study study(StudySetup setup) {
            return new AntialiasingStudy(
                    setup.studios(List.of("fig1a", "fig2a")), setup.studios(setup.names()), setup.seed(), 144, 4096);
        }
    },

    /** See {@link PrecisionStudy}. */
    PRECISION {
        @Override
        public Study study(StudySetup setup) {
            return new PrecisionStudy(setup.seed());
        }
    },

    /** See {@link TreeStudy}. */
    TREE {
        @Override
        public Study study(StudySetup setup) {
            return new TreeStudy(setup.seed(), 1_000_000);
        }
    },

    /** See {@link DepthStudy}. */
    DEPTH {
        @Override
        public Study study(StudySetup setup) {
            return new DepthStudy();
        }
    },

    /** See {@link PreviewStudy}. */
    PREVIEW {
        @Override
        public Study study(StudySetup setup) {
            return new PreviewStudy(setup.studios(List.of("fig1a", "fig1b")));
        }
    },

    /** See {@link StabilityStudy}. */
    STABILITY {
        @Override
        public Study study(StudySetup setup) {
            return new StabilityStudy(setup.seed());
        }
    };

    /** Prepares the study. */
    public abstract Study study(StudySetup setup);

    /** Whether a user's scene can be measured. */
    public boolean takesScene() {
        return this == APERTURE || this == ANTIALIASING || this == PREVIEW;
    }

    /** The name on the command line. */
    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }
}
