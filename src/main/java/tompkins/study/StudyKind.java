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
    };

    /** Prepares the study. */
    public abstract Study study(StudySetup setup);

    /** Whether a user's scene can be measured. */
    public boolean takesScene() {
        return this == APERTURE;
    }

    /** The name on the command line. */
    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }
}
